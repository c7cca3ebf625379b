#include <algorithm>

#include "src/simulation/taskplan/goal_holds.hpp"
#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

/// Who may move a robot out of the way: who has it, else the tasks that will have it some day.
WaitTarget Simulation::move_of(int robot, WaitTarget::Kind kind, int number) const {
  WaitTarget target{kind, number, {}, false, false};
  const int holder = allocator_->state(robot).holder;
  if (holder >= 0) {
    target.by.push_back(holder);
    target.machine = kind == WaitTarget::Kind::activity;
    return target;
  }
  target.idle = true;
  if (may_park_some_day(robot)) return target;
  for (const int task : tasks_of_[index(robot)]) {
    if (!is_over(task)) target.by.push_back(task);
  }
  return target;
}

/// Whether an idle robot may still be asked to its park position.
bool Simulation::may_park_some_day(int robot) const {
  if (!robot_spec(robot).park || parking_failed_[index(robot)].count >= kMostParkings) return false;
  return !goal_holds(robot_spec(robot).robot->model, site_.robot(robot).mounting,
                     site_.configuration(robot), *parks_[index(robot)].go, {});
}

void Simulation::add_resource(WaitSet& waits, int task, int resource) const {
  const int holder = allocator_->state(resource).holder;
  if (holder < 0 || holder == task) return;
  waits.targets.push_back({WaitTarget::Kind::resource, resource, {holder}, false, false});
}

/// The links of a task whose event is not known yet.
void Simulation::add_links(WaitSet& waits, int task, WaitTarget::Kind kind) const {
  const auto end =
      kind == WaitTarget::Kind::start ? schedule::TaskEnd::start : schedule::TaskEnd::finish;
  for (const int link : links_->open_links(task, end)) {
    const int before = links_->links_of(task)[index(link)].task;
    if (!is_over(before)) waits.targets.push_back({kind, link, {before}, false, false});
  }
}

/// What a task waits for that only other tasks can bring about.
std::optional<WaitSet> Simulation::waits_of(int task) const {
  if (is_over(task)) return std::nullopt;
  WaitSet waits;
  const ActiveTask* const active = look_at_active(task);
  if (!active && status_[index(task)] == Status::asking) {
    for (const ZoneWait& wait : now_.zone_waits) {
      if (wait.task != task) continue;
      const auto robot = site_.machine_in(spec(task).zones, spec(task).robot);
      if (robot) waits.targets.push_back(move_of(*robot, WaitTarget::Kind::zone, *robot));
    }
    for (const int resource : allocator_->resources(queue_[index(task)])) {
      add_resource(waits, task, resource);
    }
  } else if (!active) {
    add_links(waits, task, WaitTarget::Kind::start);
  } else if (active->wake) {
    return waits;
  } else if (active->doing == Doing::waiting_for_machine) {
    waits.any = true;
    for (std::size_t i = 0; i < active->blockers.size(); ++i) {
      const Blocker& blocker = active->blockers[i];
      const int number = static_cast<int>(i);
      constexpr auto kKind = WaitTarget::Kind::activity;
      waits.targets.push_back(blocker.robot >= 0
                                  ? move_of(blocker.robot, kKind, number)
                                  : WaitTarget{kKind, number, {blocker.zone_task}, false, false});
    }
  } else if (active->doing == Doing::waiting_for_crew) {
    add_resource(waits, task, active->crew);
  } else if (active->doing == Doing::held) {
    add_links(waits, task, WaitTarget::Kind::finish);
  }
  return waits;
}

/// Those who wait for a robot that is given back now wait for whoever will have it next.
void Simulation::look_again_who_waits_for(int robot) {
  for (const auto& active : now_.active) {
    if (active->doing != Doing::waiting_for_machine) continue;
    const bool waits = std::any_of(active->blockers.begin(), active->blockers.end(),
                                   [&](const Blocker& blocker) { return blocker.robot == robot; });
    if (waits) new_waits_.push_back(active->task);
  }
  for (const ZoneWait& wait : now_.zone_waits) {
    if (wait.robot == robot) new_waits_.push_back(wait.task);
  }
}

/// Some tasks are gone, and with them what others waited for.
void Simulation::look_again_at_all() {
  for (const auto& active : now_.active) new_waits_.push_back(active->task);
  for (const ZoneWait& wait : now_.zone_waits) new_waits_.push_back(wait.task);
}

}  // namespace rubicon::taskplan
