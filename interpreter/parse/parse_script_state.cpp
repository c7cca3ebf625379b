#include "interpreter/parse/parse_script.hpp"

namespace rubicon::interpreter {

using syntax::Statement;

void ScriptState::roll_back(const Checkpoint& checkpoint) {
  FrameState::roll_back(checkpoint);
  open_.resize(checkpoint.statements);
}

void ScriptState::begin_statement(Statement::Kind kind, const char* from) {
  Open& open = open_.emplace_back();
  open.errors = errors();
  open.statement.kind = kind;
  open.statement.keyword = span_from(from);
  open.statement.span = open.statement.keyword;
}

void ScriptState::hand_over(Statement statement) {
  if (open_.empty()) {
    (in_behaviour_ ? script_.behaviours.back().statements : script_.statements)
        .push_back(std::move(statement));
    return;
  }
  Statement& parent = open_.back().statement;
  if (parent.kind != Statement::Kind::which) {
    parent.elements.push_back(std::move(statement));
    return;
  }
  if (parent.modules.empty()) parent.modules.emplace_back();
  parent.modules.back().statements.push_back(std::move(statement));
}

void ScriptState::finish_statement() {
  Open open = std::move(open_.back());
  open_.pop_back();
  open.statement.span.end = span_from(last_end).begin;
  // A statement with a mistake inside is broken as a whole.
  if (open_.empty() && open.errors != errors()) {
    Statement broken;
    broken.span = open.statement.span;
    broken.keyword = open.statement.keyword;
    open.statement = std::move(broken);
  }
  hand_over(std::move(open.statement));
}

void ScriptState::add_broken_statement(const char* at) {
  if (skipped_remark()) return;
  Statement statement;
  statement.span = span(at, at);
  statement.keyword = statement.span;
  hand_over(std::move(statement));
}

void ScriptState::begin_module() { statement().modules.emplace_back(); }

void ScriptState::add_label(syntax::Label label) {
  statement().modules.back().labels.push_back(std::move(label));
}

void ScriptState::begin_behaviour() {
  in_behaviour_ = true;
  script_.behaviours.emplace_back();
  script_.behaviours.back().name = take_name();
}

void ScriptState::end_behaviour(const char* from) {
  script_.behaviours.back().span = span_from(from);
  in_behaviour_ = false;
}

syntax::Script ScriptState::take_script(const char* from) {
  script_.span = span_from(from);
  in_behaviour_ = false;
  return std::exchange(script_, {});
}

}  // namespace rubicon::interpreter
