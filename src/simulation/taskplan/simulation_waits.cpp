#include <algorithm>

#include "src/simulation/taskplan/goal_holds.hpp"
#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

/// Who may move a robot out of the way: who has it, else the tasks that will have it some day.
Awaited Simulation::move_of(int robot, Awaited::Kind kind, int number) const {
  Awaited awaited{kind, number, {}, false};
  const int holder = desk_->state(robot).holder;
  if (holder >= 0) {
    awaited.by.push_back(holder);
    return awaited;
  }
  awaited.idle = true;
  if (may_park_some_day(robot)) return awaited;
  for (const int task : tasks_of_[index(robot)]) {
    if (!is_over(task)) awaited.by.push_back(task);
  }
  return awaited;
}

/// Whether an idle robot may still be asked to its park position.
bool Simulation::may_park_some_day(int robot) const {
  if (!robot_spec(robot).park || parking_failed_[index(robot)].count >= kMostParkings) return false;
  return !goal_holds(robot_spec(robot).robot->model, site_.robot(robot).mounting,
                     site_.configuration(robot), *parks_[index(robot)].go, {});
}

void Simulation::add_resource(Waits& waits, int task, int resource) const {
  const int holder = desk_->state(resource).holder;
  if (holder < 0 || holder == task) return;
  waits.awaited.push_back({Awaited::Kind::resource, resource, {holder}, false});
}

/// The links of a task whose event is not known yet.
void Simulation::add_links(Waits& waits, int task, Awaited::Kind kind) const {
  const std::vector<schedule::Link>& links = network_.tasks[index(task)].after;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto& [before, type, lag, clock] = links[i];
    const bool holds = kind == Awaited::Kind::start ? waits_to_start(task, type)
                                                    : end_after(type) == schedule::TaskEnd::finish;
    const int event = end_before(type) == schedule::TaskEnd::start ? 1 : 2;
    if (!holds || (known_[index(before)] & event) != 0 || is_over(before)) continue;
    waits.awaited.push_back({kind, static_cast<int>(i), {before}, false});
  }
}

/// What a task waits for that only other tasks can bring about.
Waits Simulation::waits_of(int task) const {
  Waits waits;
  const ActiveTask* const active = look_at_active(task);
  if (!active && status_[index(task)] == Status::asking) {
    for (const ZoneWait& wait : now_.zone_waits) {
      if (wait.task != task) continue;
      const auto robot = site_.machine_in(spec(task).zones, spec(task).robot);
      if (robot) waits.awaited.push_back(move_of(*robot, Awaited::Kind::zone, *robot));
    }
    for (const int resource : desk_->resources(queue_[index(task)])) {
      add_resource(waits, task, resource);
    }
  } else if (!active) {
    add_links(waits, task, Awaited::Kind::start);
  } else if (active->wake) {
    return waits;
  } else if (active->doing == Doing::waiting_for_machine) {
    waits.for_any = true;
    for (std::size_t i = 0; i < active->blockers.size(); ++i) {
      const Blocker& blocker = active->blockers[i];
      const int number = static_cast<int>(i);
      waits.awaited.push_back(
          blocker.robot >= 0 ? move_of(blocker.robot, Awaited::Kind::way, number)
                             : Awaited{Awaited::Kind::way, number, {blocker.zone_task}, false});
    }
  } else if (active->doing == Doing::waiting_for_crew) {
    add_resource(waits, task, active->crew);
  } else if (active->doing == Doing::held) {
    add_links(waits, task, Awaited::Kind::finish);
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

/// Some tasks are gone, and with them what others hoped for.
void Simulation::look_again_at_all() {
  for (const auto& active : now_.active) new_waits_.push_back(active->task);
  for (const ZoneWait& wait : now_.zone_waits) new_waits_.push_back(wait.task);
}

}  // namespace rubicon::taskplan
