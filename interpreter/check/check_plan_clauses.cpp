#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using robot::FreeTurn;

const std::map<std::string, FreeTurn> kTurns = {
    {"rotx", FreeTurn::x}, {"roty", FreeTurn::y}, {"rotz", FreeTurn::z}};

/// One axis of the tool, or all three.
void resolve_free(Subject& subject, const syntax::MotionClause& clause, MotionClauses& clauses) {
  std::map<std::string, Span> given;
  for (const syntax::Name& turn : clause.turns) {
    const auto found = kTurns.find(turn.text);
    if (found == kTurns.end()) {
      subject.error("P47", turn.span,
                    fmt::format("expected rotx, roty or rotz, found '{}'", turn.text),
                    "free rotz; leaves the turn about the tool's own z axis as it comes");
      return;
    }
    const auto [place, is_new] = given.emplace(turn.text, turn.span);
    if (!is_new) {
      subject.twice(turn.span, fmt::format("{} is free twice", turn.text), place->second);
      return;
    }
    clauses.free = found->second;
  }
  if (given.size() == 2) {
    subject.error("P47", clause.span, "two turns are free, which says nothing of the third",
                  "name one, or all three: free rotx, roty, rotz;");
  }
  if (given.size() == 3) clauses.free = FreeTurn::all;
}

void resolve_locked(Subject& subject, const RobotSpec& robot, const syntax::MotionClause& clause,
                    MotionClauses& clauses) {
  const robot::RobotModel& model = robot.robot->model;
  for (const syntax::QualifiedName& name : clause.parameters) {
    const auto index = find_parameter(subject, robot, name);
    if (!index) continue;
    const auto place = std::lower_bound(clauses.locked.begin(), clauses.locked.end(), *index);
    if (model.parameters[static_cast<std::size_t>(*index)].derived) {
      subject.error("P47", name.span,
                    fmt::format("'{}' is derived from other parameters; lock these", name.text()));
    } else if (place != clauses.locked.end() && *place == *index) {
      subject.error("P02", name.span, fmt::format("'{}' is locked twice", name.text()));
    } else {
      clauses.locked.insert(place, *index);
    }
  }
}

/// Only what the tool frame belongs to cuts into anything.
void resolve_entered(Subject& subject, const Scope& scope, const RobotSpec& robot,
                     const syntax::MotionClause& clause, MotionClauses& clauses) {
  const robot::RobotModel& model = robot.robot->model;
  const int body = model.find_body(clause.body->text);
  const std::string& tool = model.bodies[static_cast<std::size_t>(model.tool_body)].name;
  if (body != model.tool_body) {
    subject.error("P48", clause.body->span,
                  body < 0
                      ? fmt::format("robot '{}' has no body '{}'", robot.name, clause.body->text)
                      : fmt::format("'{}' is not the tool of robot '{}': no other body may "
                                    "enter a component",
                                    clause.body->text, robot.name),
                  fmt::format("the body of its tool is {}", tool));
    return;
  }
  const auto component = find_component(subject, scope, clause.component);
  if (component) clauses.entered.emplace_back(body, *component);
}

}  // namespace

void resolve_clause(Subject& subject, const Scope& scope, const RobotSpec* robot,
                    const syntax::MotionClause& clause, MotionClauses& clauses) {
  const bool known = robot != nullptr && robot->robot && robot->robot->usable;
  if (clause.key.text == "free") {
    resolve_free(subject, clause, clauses);
  } else if (clause.key.text == "near") {
    clauses.near = resolve_values(subject, robot, clause.values, ValueUse::near);
  } else if (clause.key.text == "lock") {
    if (known) resolve_locked(subject, *robot, clause, clauses);
  } else if (clause.key.text == "enter") {
    if (known) resolve_entered(subject, scope, *robot, clause, clauses);
  } else {
    clauses.deviation = resolve_deviation(clause, "P09", subject.diagnostics);
  }
}

void check_clauses(Subject& subject, const RobotSpec* robot, const MotionClauses& clauses,
                   std::span<const GoalSpec> goals, bool moves_component,
                   const std::map<std::string, Span>& given) {
  const auto span_of = [&](const char* key) -> const Span* {
    const auto found = given.find(key);
    return found == given.end() ? nullptr : &found->second;
  };
  const bool frames =
      moves_component || std::any_of(goals.begin(), goals.end(),
                                     [](const GoalSpec& goal) { return goal.X_WG.has_value(); });
  for (const char* key : {"free", "near"}) {
    const Span* const span = span_of(key);
    if (span == nullptr || frames) continue;
    subject.error("P47", *span,
                  fmt::format("{} is about goals that are frames; here all goals are values", key));
  }
  if (const Span* const span = span_of("free"); span != nullptr && moves_component) {
    subject.error("P47", *span,
                  "free cannot stand beside move: the component would be set down turned",
                  "say how it may be turned with within, or let people turn it: adjust 4 min "
                  "turning theta;");
  }
  if (robot == nullptr || !robot->robot) return;
  const auto name_of = [&](int parameter) {
    return robot->robot->model.parameters[static_cast<std::size_t>(parameter)].display_name;
  };
  for (const auto& [parameter, value] : clauses.near) {
    if (clauses.locks(parameter)) {
      subject.error("P47", *span_of("near"),
                    fmt::format("{} is locked: it stays where it is", name_of(parameter)));
    }
  }
  for (const GoalSpec& goal : goals) {
    for (const auto& [parameter, value] : goal.values) {
      if (!clauses.locks(parameter)) continue;
      subject.error("P47", goal.span,
                    fmt::format("the goal names {}, which is locked", name_of(parameter)));
    }
  }
}

}  // namespace rubicon::interpreter::plan_check
