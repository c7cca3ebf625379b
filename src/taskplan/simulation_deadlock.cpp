#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "src/taskplan/simulation.hpp"

namespace rubicon::taskplan {

namespace {

std::string meeting(const Blocker& blocker) {
  return fmt::format("{} meets {}", blocker.moved, blocker.met);
}

using Waiting = std::vector<const ActiveTask*>;
using WaitsFor = std::function<const ActiveTask*(const Blocker&)>;

/// Starting anywhere among tasks each of which waits for another of them, a ring of these.
Waiting ring_among(const Waiting& waiting, const WaitsFor& waits_for) {
  Waiting ring;
  for (const ActiveTask* at = waiting.front();; at = waits_for(at->blockers.front())) {
    const auto again = std::find(ring.begin(), ring.end(), at);
    if (again != ring.end()) {
      ring.erase(ring.begin(), again);
      return ring;
    }
    ring.push_back(at);
  }
}

}  // namespace

/// Machines that wait for each other, so that none can ever go on: one of their tasks is rejected.
/// Seen as soon as the last of them begins to wait.
bool Simulation::find_ring() {
  Waiting waiting;
  for (const auto& active : now_.active) {
    if (active->doing == Doing::waiting_for_machine && !active->wake) {
      waiting.push_back(active.get());
    }
  }
  const WaitsFor waits_for = [&](const Blocker& blocker) -> const ActiveTask* {
    for (const ActiveTask* other : waiting) {
      if (blocker.zone_task >= 0 ? other->task == blocker.zone_task
                                 : spec(other->task).robot == blocker.robot) {
        return other;
      }
    }
    return nullptr;
  };
  // Who has anything in the way that may still move has hope.
  while (std::erase_if(waiting, [&](const ActiveTask* active) {
           return std::any_of(active->blockers.begin(), active->blockers.end(),
                              [&](const Blocker& blocker) { return !waits_for(blocker); });
         }) > 0) {
  }
  if (waiting.empty()) return false;
  const Waiting ring = ring_among(waiting, waits_for);
  std::string text = "machines wait for each other: ";
  std::vector<int> tasks;
  for (const ActiveTask* each : ring) {
    if (!tasks.empty()) text += ", ";
    tasks.push_back(each->task);
    const Blocker& blocker = each->blockers.front();
    const int robot = spec(each->task).robot;
    text += fmt::format("{} ({}) waits for {}: {}", robot_spec(robot).name, spec(each->task).name,
                        blocker.robot >= 0 ? robot_spec(blocker.robot).name : blocker.met,
                        meeting(blocker));
  }
  rejection_ = Rejection{last_of(tasks), std::move(text)};
  return true;
}

/// Of several tasks the one that gives way: parking first, then the least priority, of equals the
/// last in the file.
int Simulation::last_of(const std::vector<int>& tasks) const {
  const auto key = [&](int task) { return std::tuple(is_park(task), -spec(task).priority, task); };
  return *std::max_element(tasks.begin(), tasks.end(),
                           [&](int a, int b) { return key(a) < key(b); });
}

/// Of tasks that wait for machines for ever, one that is near enough to its goal goes on as it is
/// (carrying may end short); false if there is none.
bool Simulation::lets_one_go_on(const std::vector<int>& tasks) {
  for (const int task : tasks) {
    ActiveTask* const active = find_active(task);
    if (!active || active->doing != Doing::waiting_for_machine || !active->may_go_on) continue;
    active->outcome.waits.machine += now_.now - active->since;
    pause(*active, "machine", active->blockers.front().met);
    run_phases_after(*active);
    spread();
    return true;
  }
  return false;
}

/// The tasks that have to go on before this one can: nobody's, if what it waits for never comes.
std::vector<int> Simulation::waits_on(int task) const {
  std::vector<int> result;
  const auto add_holder = [&](int resource) {
    const int holder = desk_->state(resource).holder;
    if (holder >= 0 && holder != task) result.push_back(holder);
  };
  const ActiveTask* const active = look_at_active(task);
  if (active && active->doing == Doing::waiting_for_machine) {
    for (const Blocker& blocker : active->blockers) {
      if (blocker.zone_task >= 0) result.push_back(blocker.zone_task);
      if (blocker.robot >= 0) add_holder(blocker.robot);
    }
  } else if (active && active->doing == Doing::waiting_for_crew) {
    add_holder(active->crew);
  } else if (!active && status_[index(task)] == Status::asking) {
    for (const ZoneWait& wait : now_.zone_waits) {
      if (wait.task == task) add_holder(wait.robot);
    }
    for (const int resource : desk_->resources(queue_[index(task)])) add_holder(resource);
  } else {
    for (const schedule::Link& link : network_.tasks[index(task)].after)
      result.push_back(link.task);
  }
  std::erase_if(result, [&](int other) { return is_over(other); });
  return result;
}

/// Nothing will happen any more, but some tasks have not finished: the one that the others wait for
/// is rejected. False if all have finished.
bool Simulation::resolve_standstill() {
  int task = -1;
  if (!now_.active.empty()) task = now_.active.front()->task;
  for (int i = 0; task < 0 && i < static_cast<int>(plan_.tasks.size()); ++i) {
    if (!is_over(i)) task = i;
  }
  if (task < 0) return false;
  std::vector<int> way;
  while (true) {
    const auto again = std::find(way.begin(), way.end(), task);
    if (again != way.end()) {
      task = last_of({again, way.end()});
      break;
    }
    way.push_back(task);
    const std::vector<int> others = waits_on(task);
    if (others.empty()) break;
    task = others.front();
  }
  if (lets_one_go_on(way)) return true;
  rejection_ = Rejection{task, standstill_reason(task)};
  return true;
}

std::string Simulation::standstill_reason(int task) {
  const auto zone = std::find_if(now_.zone_waits.begin(), now_.zone_waits.end(),
                                 [&](const ZoneWait& wait) { return wait.task == task; });
  if (zone != now_.zone_waits.end()) {
    return fmt::format("{} stands in its zone and does not move any more",
                       robot_spec(zone->robot).name);
  }
  const ActiveTask* const active = find_active(task);
  if (!active) return "no shift of all that it needs ever begins";
  if (active->doing == Doing::waiting_for_machine) {
    const Blocker& blocker = active->blockers.front();
    std::string reason =
        fmt::format("blocked for ever: {}, which does not move any more", meeting(blocker));
    if (blocker.robot >= 0 && !robot_spec(blocker.robot).park) {
      reason += fmt::format("; give {} a park position", robot_spec(blocker.robot).name);
    }
    return reason;
  }
  if (active->doing == Doing::waiting_for_crew) {
    const int holder = desk_->state(active->crew).holder;
    return fmt::format("it never gets {}, which {} holds", desk_->name(active->crew),
                       holder >= 0 ? spec(holder).name : std::string("nobody"));
  }
  return "its links never let it finish";
}

}  // namespace rubicon::taskplan
