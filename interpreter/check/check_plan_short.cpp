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
    } else if (const auto* within = std::get_if<syntax::WithinItem>(&each)) {
      resolve_within(subject, robot, *within, model.within);
    }
  }
}

}  // namespace rubicon::interpreter::plan_check
