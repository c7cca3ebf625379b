#pragma once

#include "grammar/guide.hpp"
#include "interpreter/parse/parse_script.hpp"

/// Actions of guides. Only for the parse_*.cpp files.
namespace rubicon::interpreter {

/// The guide under construction, of a robot or of a plan.
class GuideState : public ScriptState {
 public:
  using ScriptState::ScriptState;

  void begin_guide() {
    guide = {};
    guide_names.clear();
    announce("guide");
  }
  syntax::GuideClause& clause() { return guide.clauses.back(); }

  syntax::GuideDeclaration guide;
  std::vector<syntax::Name> guide_names;  ///< those that a task uses
  syntax::QualifiedName clause_parameter;
};

template <typename Rule>
struct GuideAction : ScriptAction<Rule> {};

RUBICON_ACTION(GuideAction, GuideState, guide_key) { st.begin_guide(); }
RUBICON_ACTION(GuideAction, GuideState, guide_name) {
  st.guide.name = st.take_name();
  st.guide_names = {st.guide.name};
}
RUBICON_ACTION(GuideAction, GuideState, guide_kind) { st.guide.kind = st.take_name(); }
RUBICON_ACTION(GuideAction, GuideState, guide_planner) { st.guide.planner = st.string; }
RUBICON_ACTION(GuideAction, GuideState, clause_key) {
  st.guide.clauses.emplace_back();
  st.clause().key = st.take_name();
}
RUBICON_ACTION(GuideAction, GuideState, keep_key) {
  st.guide.clauses.emplace_back();
  st.clause().key = {std::string(begin, st.last_end), st.span_from(begin)};
}
RUBICON_ACTION(GuideAction, GuideState, keep_condition) {
  st.clause().condition = st.take_expression();
}
RUBICON_ACTION(GuideAction, GuideState, thinks_key) {
  st.guide.clauses.emplace_back();
  st.clause().key = {std::string(begin, st.last_end), st.span_from(begin)};
}
RUBICON_ACTION(GuideAction, GuideState, thinks_number) {
  st.clause().number = st.number;
  st.clause().number->span = st.span_from(begin);
}
RUBICON_ACTION(GuideAction, GuideState, thinks_unit) {
  const std::string_view unit(begin, static_cast<std::size_t>(st.last_end - begin));
  const double seconds = unit == "us" ? 1e6 : unit == "ms" ? 1e3 : 1;
  st.clause().thinking = st.clause().number->value / seconds;
}
RUBICON_ACTION(GuideAction, GuideState, set_key) {
  st.guide.clauses.emplace_back();
  st.clause().key = {std::string(begin, st.last_end), st.span_from(begin)};
}
RUBICON_ACTION(GuideAction, GuideState, set_name) { st.clause().setting = st.string; }
RUBICON_ACTION(GuideAction, GuideState, set_number) { st.clause().number = st.number; }
RUBICON_ACTION(GuideAction, GuideState, clause_parameter) {
  st.clause_parameter = st.take_qualified_name();
}
RUBICON_ACTION(GuideAction, GuideState, clause_word) {
  st.clause().words.push_back(st.take_qualified_name());
}
RUBICON_ACTION(GuideAction, GuideState, clause_number) { st.clause().number = st.number; }
RUBICON_ACTION(GuideAction, GuideState, clause_value) {
  st.clause().values.push_back({std::move(st.clause_parameter), *st.clause().number});
  st.clause().number.reset();
}
RUBICON_ACTION(GuideAction, GuideState, guide_clause) { st.clause().span = st.span_from(begin); }
RUBICON_ACTION(GuideAction, GuideState, used_guide) { st.guide_names.push_back(st.take_name()); }
RUBICON_ACTION(GuideAction, GuideState, next_guide) { st.guide_names.push_back(st.take_name()); }

}  // namespace rubicon::interpreter
