#pragma once

#include "grammar/messages.hpp"
#include "interpreter/parse/parse_state.hpp"

/// How PEGTL and the state of a parse meet. Only for the parse_*.cpp files.
namespace rubicon::interpreter {

/// Raises through ParseState::fail, with the expectation of the rule that did not match.
template <typename Rule>
struct ParseControl : tao::pegtl::normal<Rule> {
  template <typename ParseInput, typename State>
  [[noreturn]] static void raise(const ParseInput& in, State& state) {
    state.fail(in.current(), grammar::expectation<Rule>);
  }
};

using ParseInput = tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy,
                                            tao::pegtl::eol::lf_crlf, const char*>;

/// Runs `Grammar` over the text of `state`. False if it gave up before the end.
template <typename Grammar, template <typename...> class Action, typename State>
bool run_parser(State& state) {
  try {
    if (static_cast<std::size_t>(state.end() - state.begin()) > kMaxTextBytes) {
      state.report("F00", state.begin(), state.begin(), "this file is larger than 256 MB");
      return false;
    }
    state.check_bytes();
    ParseInput in(state.begin(), state.end(), "");
    return tao::pegtl::parse<Grammar, Action, ParseControl>(in, state);
  } catch (const ParseAborted&) {
    return false;
  } catch (const ParseFailure&) {
    return false;
  }
}

}  // namespace rubicon::interpreter
