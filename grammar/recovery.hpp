#pragma once

#include <tao/pegtl/contrib/analyze_traits.hpp>

#include "grammar/expectation.hpp"
#include "grammar/lexical.hpp"

/// Rules that keep the parser going after a mistake and its stack bounded. They talk to the state
/// of the parse: `checkpoint`, `begin_item`, `roll_back`, `skip`, `ask`, `enter` and `leave`.
namespace rubicon::grammar {

struct statement_end {
  static constexpr Resume kind = Resume::statement;
};
struct element_end {
  static constexpr Resume kind = Resume::element;
};
struct item_end {
  static constexpr Resume kind = Resume::item;
};
struct text_end {
  static constexpr Resume kind = Resume::nowhere;
};

/// Matches nothing, if the state says so.
template <Query query>
struct ask {
  using rule_t = ask;
  using subs_t = empty_list;

  template <apply_mode A, rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename ParseInput, typename State>
  [[nodiscard]] static bool match(ParseInput& in, State& state) {
    return state.ask(query, in.current());
  }
};

/// What follows when `Rule` could not be parsed: an empty match, for actions.
template <typename Rule>
struct broken : success {};

/// Matches `Rule`. If a mistake was raised in it, goes on behind the mistake at the next place
/// `Place` asks for (see ParseState::skip) and matches, too, with `broken<Rule>`.
template <typename Rule, typename Place>
struct recover {
  using rule_t = recover;
  using subs_t = type_list<Rule>;

  template <apply_mode A, rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename ParseInput, typename State>
  [[nodiscard]] static bool match(ParseInput& in, State& state) {
    const auto checkpoint = state.checkpoint();
    const char* const begin = in.current();
    state.begin_item(begin);
    try {
      const bool matched =
          Control<Rule>::template match<A, rewind_mode::required, Action, Control>(in, state);
      state.begin_item(checkpoint.item_begin);
      return matched;
    } catch (const typename State::Failure& failure) {
      state.roll_back(checkpoint);
      in.iterator() = state.skip(Place::kind, begin, failure);
    }
    return Control<broken<Rule>>::template match<A, M, Action, Control>(in, state);
  }
};

/// One level of nesting deeper; too deep is a mistake of its own.
template <typename Rule>
struct nested {
  using rule_t = nested;
  using subs_t = type_list<Rule>;

  template <apply_mode A, rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename ParseInput, typename State>
  [[nodiscard]] static bool match(ParseInput& in, State& state) {
    state.enter(in.current());
    const bool matched = Control<Rule>::template match<A, M, Action, Control>(in, state);
    state.leave();
    return matched;
  }
};

}  // namespace rubicon::grammar

namespace tao::pegtl {

template <typename Name, typename Rule, typename Place>
struct analyze_traits<Name, rubicon::grammar::recover<Rule, Place>>
    : analyze_traits<Name, typename seq<Rule>::rule_t> {};

template <typename Name, rubicon::grammar::Query query>
struct analyze_traits<Name, rubicon::grammar::ask<query>> : analyze_opt_traits<> {};

template <typename Name, typename Rule>
struct analyze_traits<Name, rubicon::grammar::nested<Rule>>
    : analyze_traits<Name, typename seq<Rule>::rule_t> {};

}  // namespace tao::pegtl
