#include <utility>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

void check_short_form(Subject& subject) {
  PlanModel& model = subject.model;
  RobotSpec* robot = model.robots.empty() ? nullptr : &model.robots.front();
  // The start comes first: what a goal may be depends on it.
  const syntax::StartItem* start = nullptr;
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::StartItem>(&each);
    if (item == nullptr) continue;
    if (start != nullptr) {
      subject.twice(item->span, "start is given twice", start->span);
      continue;
    }
    start = item;
    const auto values = resolve_values(subject, robot, item->values, ValueUse::start);
    if (robot != nullptr) set_starts(subject, *robot, values, item->span);
  }
  const syntax::GuideItem* guides = nullptr;
  std::map<std::string, Span> clauses;
  for (const syntax::PlanItem& each : subject.plan.items) {
    if (const auto* goal = std::get_if<syntax::GoalItem>(&each)) {
      GoalSpec spec =
          resolve_goal(subject, robot, goal->goal, ValueUse::goal, math::Pose::Identity());
      if (!model.goal) model.goal = std::move(spec);
    } else if (const auto* via = std::get_if<syntax::ViaItem>(&each)) {
      model.via.push_back(
          resolve_goal(subject, robot, via->goal, ValueUse::via, math::Pose::Identity()));
    } else if (const auto* carry = std::get_if<syntax::CarryItem>(&each)) {
      std::optional<geometry::Shape> shape = subject.shapes.resolve(carry->shape);
      if (shape) model.carry.push_back(*std::move(shape));
    } else if (const auto* guide = std::get_if<syntax::GuideItem>(&each)) {
      if (guides != nullptr) {
        subject.twice(guide->span, "guide is given twice", guides->span);
        continue;
      }
      guides = guide;
      model.guides = resolve_guides(subject, robot, *guide);
    } else if (const auto* clause = std::get_if<syntax::MotionClause>(&each)) {
      const auto [place, is_new] = clauses.emplace(clause->key.text, clause->span);
      if (!is_new && clause->key.text != "enter") {
        subject.twice(clause->span, clause->key.text + " is given twice", place->second);
        continue;
      }
      resolve_clause(subject, {}, robot, *clause, model.clauses);
    } else if (const auto* within = std::get_if<syntax::WithinItem>(&each)) {
      resolve_within(subject, robot, *within, model.within);
    }
  }
  std::vector<GoalSpec> goals = model.via;
  if (model.goal) goals.push_back(*model.goal);
  check_clauses(subject, robot, model.clauses, goals, false, clauses);
}

}  // namespace rubicon::interpreter::plan_check
