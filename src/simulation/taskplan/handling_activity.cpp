#include "src/simulation/taskplan/handling_activity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/simulation/site/load_chart.hpp"

namespace rubicon::taskplan {

namespace {

/// Nothing if the component is where the tool took hold of it. If somebody moved it meanwhile, the
/// task begins again with its motion there.
std::optional<Step> not_there(const ActiveTask& task, Stage& stage) {
  const int component = task.now().component;
  if (!stage.site.stands(component)) {
    stage.reject(task.task, stage.gone(component), stage.users_of(component));
    return Step::pending;
  }
  if (stage.site.X_WO(component).matrix() == task.X_WO.matrix()) return std::nullopt;
  return Step::restart;
}

/// What does not stand, by what the task does: rejects it, or, where the plan only warns, notes it.
/// True if it is rejected.
bool tell_support(ActiveTask& task, Stage& stage, std::string what, std::vector<int> involved) {
  if (stage.plan.support.mode == interpreter::SupportRules::Mode::warn) {
    task.account.outcome.support.push_back(std::move(what));
    return false;
  }
  stage.reject(task.task, std::move(what), std::move(involved));
  return true;
}

/// Other tasks that put these components where they are.
std::vector<int> others_who_used(const ActiveTask& task, const Stage& stage,
                                 const std::vector<int>& components) {
  std::vector<int> involved;
  for (const int each : components) {
    const std::vector<int> users = stage.users_of(each);
    involved.insert(involved.end(), users.begin(), users.end());
  }
  std::sort(involved.begin(), involved.end());
  involved.erase(std::unique(involved.begin(), involved.end()), involved.end());
  std::erase(involved, task.task);
  return involved;
}

/// Whether the task is rejected because others do not stand without the component.
bool leaves_others(ActiveTask& task, Stage& stage, int component) {
  if (!stage.support) return false;
  const std::vector<int> others = stage.support->left_without(component);
  if (others.empty()) {
    const auto collapse = stage.support->collapse_without(component);
    return collapse &&
           tell_support(task, stage,
                        fmt::format("{} cannot be taken away: without it {}",
                                    stage.site.component_name(component), collapse->text),
                        others_who_used(task, stage, collapse->components));
  }
  return tell_support(
      task, stage,
      fmt::format("{} cannot be taken away: without it {}", stage.site.component_name(component),
                  stage.support->left_text(others)),
      others_who_used(task, stage, others));
}

/// Whether the task is rejected because a machine stands on the soil that it has dug.
bool undermines(ActiveTask& task, Stage& stage, int component) {
  constexpr double kStandsWithin = 0.05;  // m above the soil
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const bool digs = (spec.dig && spec.dig->soil == component) ||
                    (spec.motion_dig && spec.motion_dig->soil == component);
  if (!stage.support || !digs) return false;
  std::vector<geometry::Shape> above =
      stage.plan.components[static_cast<std::size_t>(component)].shapes;
  for (geometry::Shape& shape : above) {
    shape.X_BS = stage.site.X_WO(component) * shape.X_BS;
    shape.X_BS.translation().z() += kStandsWithin;
  }
  const std::optional<int> robot = stage.site.machine_in({above, {}}, spec.robot);
  if (!robot) return false;
  std::vector<int> involved;
  for (int other = 0; other < stage.plan_tasks(); ++other) {
    if (stage.spec(other).robot == *robot && stage.has_begun(other)) involved.push_back(other);
  }
  return tell_support(
      task, stage,
      fmt::format("{} cannot be taken away: {} stands on it", stage.site.component_name(component),
                  stage.robot_spec(*robot).name),
      std::move(involved));
}

/// Whether the task is rejected because the component does not stand at X_WO.
bool does_not_stand(ActiveTask& task, Stage& stage, int component, const math::Pose& X_WO,
                    const char* where) {
  if (!stage.support) return false;
  const std::optional<std::string> reason = stage.support->why_not(component, X_WO);
  if (!reason) return false;
  return tell_support(
      task, stage,
      fmt::format("{} does not stand{}: {}", stage.site.component_name(component), where, *reason),
      {});
}

/// Whether the task is rejected because the forces do not balance with the component at X_WO.
bool unbalances(ActiveTask& task, Stage& stage, int component, const math::Pose& X_WO) {
  if (!stage.support) return false;
  const auto collapse = stage.support->collapse_with(component, X_WO);
  return collapse && tell_support(task, stage,
                                  fmt::format("{} cannot be let go: {}",
                                              stage.site.component_name(component), collapse->text),
                                  others_who_used(task, stage, collapse->components));
}

}  // namespace

bool undercuts(ActiveTask& task, Stage& stage, int component) {
  return leaves_others(task, stage, component) || undermines(task, stage, component);
}

Step HandlingActivity::begin(ActiveTask& task, Stage& stage) {
  switch (task.now().kind) {
    case Phase::Kind::weigh:
      return weigh(task, stage);
    case Phase::Kind::attach:
      return begin_lift_here(task, stage);
    case Phase::Kind::detach:
      return detach(task, stage);
    default:
      return remove(task, stage);
  }
}

/// Those who were in the way have left: tried again, as a motion is.
Step HandlingActivity::resume(ActiveTask& task, Stage& stage) {
  const bool begins = task.now().begins_lift && is_held_whole(stage, task.task);
  if (holds_back_) {
    const LiftNote* const note = stage.lift_notes.of(task.task);
    held_back_ = note && since_ < note->not_before;
    const LiftNote* const waited_for = held_back_ ? note : nullptr;
    stage.end_shift_wait(task, since_, first_gain_of_lift(stage, task.task, since_, waited_for),
                         waited_for);
    holds_back_ = false;
    return attach(task, stage);
  }
  const schedule::WorkCalendar& calendar =
      begins ? lift_hours(stage, task.task) : stage.calendar(task.task);
  if (!lift_of(stage, task.task) && !calendar.works_at(stage.now())) {
    stage.events.set(task.task, calendar.next_working(stage.now()));
    return Step::pending;
  }
  const MachineWait before = wait_;
  const ActiveTask::Account account = task.account;
  const TraceOutput::Mark mark = stage.trace.mark();
  task.account.outcome.waits.machine += stage.now() - wait_.since;
  stage.pause(task.task, "machine", wait_.first_name(stage), wait_.since);
  task.hits.forget();
  wait_.blockers.clear();
  const Step step = attach(task, stage);
  if (wait_.blockers.empty() || stage.rejection) {
    before.note_wait(stage, task.task);
    return step;
  }
  wait_.since = before.since;
  task.account = account;
  stage.trace.forget_since(mark);
  return Step::pending;
}

Step HandlingActivity::weigh(ActiveTask& task, Stage& stage) {
  if (const auto step = not_there(task, stage)) return *step;
  const int robot = stage.spec(task.task).robot;
  const int component = task.now().component;
  const interpreter::RobotSpec& machine = stage.robot_spec(robot);
  const double mass = stage.plan.components[static_cast<std::size_t>(component)].mass;
  const double radius = site::chart_radius(machine.X_WM, stage.site.tool_pose(robot).translation());
  const std::vector<robot::CapacityPoint>& chart = machine.robot->model.capacity;
  if (site::may_hang(chart, mass, radius)) return Step::over;
  stage.reject(
      task.task,
      fmt::format("too heavy: {} has {:g} kg, the load chart of {} allows {:g} kg at {:g} m",
                  stage.site.component_name(component), mass, machine.name,
                  site::capacity_near(chart, radius), radius));
  return Step::pending;
}

/// A lift without hook work begins with the pick-up: in the hours of all that it needs, and not
/// before the shift into which it fits.
Step HandlingActivity::begin_lift_here(ActiveTask& task, Stage& stage) {
  if (!task.now().begins_lift || !is_held_whole(stage, task.task)) return attach(task, stage);
  const LiftNote* const note = stage.lift_notes.of(task.task);
  const Ticks begin =
      lift_hours(stage, task.task).next_working(std::max(stage.now(), note ? note->not_before : 0));
  if (begin == stage.now()) return attach(task, stage);
  if (begin >= schedule::kEndOfTime) {
    stage.reject(task.task, "there is no shift any more for all that its lift needs");
    return Step::pending;
  }
  holds_back_ = true;
  since_ = stage.now();
  stage.events.set(task.task, begin);
  return Step::pending;
}

Step HandlingActivity::attach(ActiveTask& task, Stage& stage) {
  if (const auto step = not_there(task, stage)) return *step;
  const int robot = stage.spec(task.task).robot;
  const int component = task.now().component;
  // Hanging on a machine it would be part of that, where people keep machines out.
  if (const auto zone = stage.site.zone_around(component, robot)) {
    wait_ = {{{-1, zone->zone_task, -1, stage.site.component_name(component), zone->name}},
             stage.now(),
             stage.site.traffic_changes(),
             0,
             false,
             false};
    stage.begins_to_wait(task.task);
    return Step::pending;
  }
  const bool strict = stage.plan.support.mode == interpreter::SupportRules::Mode::on;
  if ((strict && does_not_stand(task, stage, component, stage.site.X_WO(component),
                                " where it is taken up")) ||
      leaves_others(task, stage, component)) {
    return Step::pending;
  }
  if (task.now().begins_lift && is_held_whole(stage, task.task)) {
    begin_lift(task, stage, held_back_ ? stage.lift_notes.of(task.task) : nullptr);
  }
  stage.site_changes.attach(robot, component);
  if (auto* const trace = stage.trace_of(task.task)) {
    trace->attach(stage.site.component_name(component), stage.site.load(robot)->X_TO, stage.now());
  }
  stage.announce({robot, -1});
  return Step::over;
}

Step HandlingActivity::detach(ActiveTask& task, Stage& stage) {
  if (!end_lift(task, stage)) return Step::pending;
  const int robot = stage.spec(task.task).robot;
  const int component = task.now().component;
  const math::Pose X_WO = stage.site.tool_pose(robot) * stage.site.load(robot)->X_TO;
  if (does_not_stand(task, stage, component, X_WO, "") ||
      unbalances(task, stage, component, X_WO)) {
    return Step::pending;
  }
  stage.site_changes.detach(robot);
  if (auto* const trace = stage.trace_of(task.task)) {
    const interpreter::Rare<LiftOutcome>& lift = task.account.outcome.lift;
    trace->detach(stage.site.component_name(component), stage.site.X_WO(component), stage.now(),
                  lift ? lift->overtime : 0);
  }
  stage.announce({robot, -1});
  return Step::over;
}

Step HandlingActivity::remove(ActiveTask& task, Stage& stage) {
  const int component = task.now().component;
  if (!stage.site.stands(component)) {
    stage.reject(task.task, stage.gone(component), stage.users_of(component));
    return Step::pending;
  }
  // Soil that was dug bit by bit was looked at before.
  const bool was_dug = stage.site.surface(component) != nullptr;
  if (!was_dug && undercuts(task, stage, component)) return Step::pending;
  stage.site_changes.remove(component);
  if (auto* const trace = stage.trace_of(task.task)) {
    trace->remove(stage.site.component_name(component), stage.now());
  }
  return Step::over;
}

WaitSet HandlingActivity::waits(const ActiveTask&, const Stage& stage) const {
  return wait_.blockers.empty() ? WaitSet() : wait_.waits(stage);
}

std::string HandlingActivity::text_of(const ActiveTask& task, const Stage& stage,
                                      const WaitTarget& target) const {
  return text_of_way(stage, task.task, wait_.blockers[static_cast<std::size_t>(target.number)]);
}

std::string HandlingActivity::standstill_reason(const ActiveTask& task, const Stage& stage) const {
  return wait_.blockers.empty() ? std::string()
                                : wait_.standstill_reason(stage, stage.spec(task.task).robot);
}

bool HandlingActivity::wakes_at(const ActiveTask&, const Stage& stage,
                                const SiteEvent& event) const {
  return !wait_.blockers.empty() && wait_.wakes_at(stage, event);
}

}  // namespace rubicon::taskplan
