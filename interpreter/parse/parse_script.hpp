#pragma once

#include "grammar/script.hpp"
#include "interpreter/parse/parse_frame.hpp"

/// Actions of behaviour scripts. Only for the parse_*.cpp files.
namespace rubicon::interpreter {

/// The script under construction: statements that are not finished on a stack, their parents below.
class ScriptState : public FrameState {
 public:
  using FrameState::FrameState;

  struct Checkpoint : FrameState::Checkpoint {
    std::size_t statements = 0;
  };
  Checkpoint checkpoint() const { return {FrameState::checkpoint(), open_.size()}; }
  void roll_back(const Checkpoint& checkpoint);

  void begin_statement(syntax::Statement::Kind kind, const char* from);
  syntax::Statement& statement() { return open_.back().statement; }
  /// Hands the innermost statement to its parent, or to the script.
  void finish_statement();
  void add_broken_statement(const char* at);

  void begin_module();
  void add_label(syntax::Label label);

  void begin_behaviour();
  void end_behaviour(const char* from);
  void abandon_behaviour() { in_behaviour_ = false; }

  syntax::Script take_script(const char* from);

 private:
  struct Open {
    syntax::Statement statement;
    int errors;  ///< mistakes before it
  };
  void hand_over(syntax::Statement statement);

  std::vector<Open> open_;
  syntax::Script script_;
  bool in_behaviour_ = false;
};

template <typename Rule>
struct ScriptAction : FrameAction<Rule> {};

// braces
RUBICON_ACTION(ScriptAction, ParseState, block_open) { st.open_brace(begin); }
RUBICON_ACTION(ScriptAction, ParseState, close_brace) { st.close_brace(); }
RUBICON_ACTION(ScriptAction, ParseState, together_close) { st.close_brace(); }
RUBICON_ACTION(ScriptAction, ParseState, missing_brace) { st.missing_brace(begin); }
RUBICON_ACTION(ScriptAction, ParseState, missing_comma) { st.missing_comma(begin); }
RUBICON_ACTION(ScriptAction, ParseState, missing_semicolon) { st.missing_semicolon(begin); }
RUBICON_ACTION(ScriptAction, ParseState, comma_for_semicolon) { st.comma_for_semicolon(begin); }
RUBICON_ACTION(ScriptAction, ParseState, missing_label) {
  st.report_token("S13", begin,
                  "expected a label such as 'transport:' or 'default:' in this which");
}

// simple statements
RUBICON_ACTION(ScriptAction, ScriptState, move_to_key) {
  st.begin_statement(syntax::Statement::Kind::move_to, begin);
}
RUBICON_ACTION(ScriptAction, ScriptState, move_dir_key) {
  st.begin_statement(syntax::Statement::Kind::move_dir, begin);
}
RUBICON_ACTION(ScriptAction, ScriptState, command_parameter) {
  st.statement().name = st.take_qualified_name();
}
RUBICON_ACTION(ScriptAction, ScriptState, command_value) {
  st.statement().value = st.take_expression();
}
RUBICON_ACTION(ScriptAction, ScriptState, assigned_key) {
  st.begin_statement(syntax::Statement::Kind::assignment, begin);
}
RUBICON_ACTION(ScriptAction, ScriptState, assigned_name) {
  st.statement().name = st.take_qualified_name();
}
RUBICON_ACTION(ScriptAction, ScriptState, assigned_value) {
  st.statement().value = st.take_expression();
}
RUBICON_ACTION(ScriptAction, ScriptState, wait_key) {
  st.begin_statement(syntax::Statement::Kind::wait, begin);
}
RUBICON_ACTION(ScriptAction, ScriptState, used_name) {
  st.begin_statement(syntax::Statement::Kind::use, begin);
  st.statement().name = st.take_qualified_name();
}
// stop(unreachable): a behaviour that every robot has, used with a value.
RUBICON_ACTION(ScriptAction, ScriptState, stop_key) {
  st.begin_statement(syntax::Statement::Kind::use, begin);
}
RUBICON_ACTION(ScriptAction, ScriptState, stop_reason) {
  st.push_name(syntax::Expression::Kind::parameter, begin);
  st.statement().value = st.take_expression();
  st.statement().name.name = {"stop", st.statement().keyword};
}
RUBICON_ACTION(ScriptAction, ScriptState, together_key) {
  st.begin_statement(syntax::Statement::Kind::together, begin);
  st.announce("together");
}
RUBICON_ACTION(ScriptAction, ScriptState, together_part) { st.finish_statement(); }

// structures
RUBICON_ACTION(ScriptAction, ScriptState, chain_key) {
  st.begin_statement(syntax::Statement::Kind::chain, begin);
  st.announce("chain");
}
RUBICON_ACTION(ScriptAction, ScriptState, cycle_key) {
  st.begin_statement(syntax::Statement::Kind::cycle, begin);
  st.announce("cycle");
}
RUBICON_ACTION(ScriptAction, ScriptState, first_key) {
  st.begin_statement(syntax::Statement::Kind::first, begin);
  st.announce("first");
}
RUBICON_ACTION(ScriptAction, ScriptState, each_key) {
  st.begin_statement(syntax::Statement::Kind::each, begin);
  st.announce("each");
}
RUBICON_ACTION(ScriptAction, ScriptState, which_key) {
  st.begin_statement(syntax::Statement::Kind::which, begin);
  st.announce("which");
}
RUBICON_ACTION(ScriptAction, ScriptState, until_condition) {
  st.statement().until = st.take_expression();
}
RUBICON_ACTION(ScriptAction, ScriptState, module_start) { st.begin_module(); }
RUBICON_ACTION(ScriptAction, ScriptState, default_key) {
  st.add_label(
      {syntax::Label::Kind::otherwise, {"default", st.span_from(begin)}, {}, st.span_from(begin)});
}
RUBICON_ACTION(ScriptAction, ScriptState, when_key) {
  st.add_label({syntax::Label::Kind::when, {"when", st.span_from(begin)}, {}, st.span_from(begin)});
}
RUBICON_ACTION(ScriptAction, ScriptState, when_condition) {
  st.statement().modules.back().labels.back().condition = st.take_expression();
}
RUBICON_ACTION(ScriptAction, ScriptState, situation_name) {
  st.add_label({syntax::Label::Kind::situation, st.take_name(), {}, st.span_from(begin)});
}

RUBICON_ACTION(ScriptAction, ScriptState, element) { st.finish_statement(); }
RUBICON_ACTION(ScriptAction, ScriptState, finished_structure) { st.finish_statement(); }
RUBICON_ACTION(ScriptAction, ScriptState, finished_simple) { st.finish_statement(); }
RUBICON_ACTION(ScriptAction, ScriptState, broken<grammar::whole_element>) {
  st.add_broken_statement(begin);
}
RUBICON_ACTION(ScriptAction, ScriptState, broken<grammar::whole_statement>) {
  st.add_broken_statement(begin);
}

// behaviours
RUBICON_ACTION(ScriptAction, ScriptState, behaviour_key) { st.announce("behaviour"); }
RUBICON_ACTION(ScriptAction, ScriptState, behaviour_name) { st.begin_behaviour(); }
RUBICON_ACTION(ScriptAction, ScriptState, whole_behaviour) { st.end_behaviour(begin); }
RUBICON_ACTION(ScriptAction, ScriptState, broken<grammar::whole_behaviour>) {
  st.abandon_behaviour();
}

}  // namespace rubicon::interpreter
