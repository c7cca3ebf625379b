#include "src/simulation/taskplan/breakdowns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "src/simulation/taskplan/active_task.hpp"
#include "src/simulation/taskplan/stage.hpp"

namespace rubicon::taskplan {

namespace {

/// A machine works so long at least before it breaks down again: the draws of some laws are as
/// short as one likes.
constexpr Ticks kLeastBetweenBreakdowns = schedule::kSecond;

/// So often machines break down in a run: more is a slip of the pen, and would fill the memory.
constexpr std::size_t kMostBreakdowns = 100'000;

}  // namespace

Breakdowns::Breakdowns(const interpreter::PlanModel& plan,
                       const std::optional<interpreter::SampleSpec>& sample)
    : plan_(&plan), sample_(sample) {
  if (!sample || !interpreter::has_breakdowns(plan)) return;
  machines_.resize(plan.robots.size());
  for (std::size_t i = 0; i < machines_.size(); ++i) {
    if (!plan.robots[i].breakdown) continue;
    machines_[i].breaks = true;
    draw(static_cast<int>(i));
  }
}

Ticks Breakdowns::drawn(const sampling::DurationLaw& law, const std::string& name,
                        std::uint64_t use) const {
  const sampling::Place place{sample_->seed, sample_->run, name, use};
  return schedule::within_time(schedule::ticks_from_seconds(sampling::draw(law, place)));
}

void Breakdowns::draw(int robot) {
  const interpreter::RobotSpec& spec = plan_->robots[static_cast<std::size_t>(robot)];
  Machine& each = machine(robot);
  each.every = std::max(kLeastBetweenBreakdowns,
                        drawn(spec.breakdown->every, spec.name + ".breakdown", each.uses));
}

Ticks Breakdowns::left(int robot, Ticks in_task) const {
  const Machine& each = machine(robot);
  return std::max<Ticks>(each.every - each.worked - in_task, 0);
}

Breakdowns::Repair Breakdowns::begin_repair(int robot, Ticks in_task) {
  const interpreter::RobotSpec& spec = plan_->robots[static_cast<std::size_t>(robot)];
  Machine& each = machine(robot);
  Repair repair;
  repair.every = each.every;
  repair.worked = each.worked + in_task;
  repair.time = drawn(spec.breakdown->takes, spec.name + ".repair", each.uses++);
  each.worked = -in_task;
  draw(robot);
  return repair;
}

void Breakdowns::give_back(int robot, Ticks in_task) { machine(robot).worked += in_task; }

Ticks Breakdowns::next_repaired(Ticks now) const {
  Ticks next = schedule::kEndOfTime;
  for (const Machine& each : machines_) {
    if (each.out_until > now) next = std::min(next, each.out_until);
  }
  return next;
}

Ticks work_in(const ActiveTask& task) {
  return task.account.outcome.motion_time + task.account.outcome.work_time;
}

bool breaks_down_now(const ActiveTask& task, const Stage& stage) {
  const int robot = stage.spec(task.task).robot;
  if (!stage.breakdowns.breaks(robot)) return false;
  if (stage.breakdowns.left(robot, work_in(task)) > 0) return false;
  const bool lifts = std::any_of(stage.lifts.begin(), stage.lifts.end(),
                                 [&](const WholeLift& lift) { return lift.task == task.task; });
  return !lifts && !stage.site.load(robot);
}

Ticks begin_repair(const ActiveTask& task, Stage& stage) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  if (stage.breakdown_outcomes.size() >= kMostBreakdowns) return schedule::kEndOfTime;
  const Breakdowns::Repair repair = stage.breakdowns.begin_repair(spec.robot, work_in(task));
  const Ticks end = stage.allocator->hours(spec.robot).finish(stage.now(), repair.time);
  const std::string& machine = stage.robot_spec(spec.robot).name;
  stage.breakdown_outcomes.push_back(
      {machine, spec.name, repair.worked, repair.time, stage.now(), end});
  stage.trace.breakdown(
      {machine, spec.name, repair.every, repair.worked, repair.time, stage.now(), end});
  return end;
}

std::string never_repaired(const Stage& stage) {
  return stage.breakdown_outcomes.size() >= kMostBreakdowns
             ? fmt::format("machines broke down {} times before", kMostBreakdowns)
             : "a repair of its machine is not done within 126 years";
}

}  // namespace rubicon::taskplan
