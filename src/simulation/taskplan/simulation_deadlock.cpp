#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

namespace {

std::string meeting(const Blocker& blocker) {
  return fmt::format("{} meets {}", blocker.moved, blocker.met);
}

}  // namespace

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

/// Nothing will happen any more, but some tasks have not finished: the one that the others wait for
/// is rejected. False if all have finished.
bool Simulation::resolve_standstill() {
  int task = -1;
  if (!now_.active.empty()) task = now_.active.front()->task;
  for (int i = 0; task < 0 && i < static_cast<int>(plan_.tasks.size()); ++i) {
    if (!is_over(i)) task = i;
  }
  if (task < 0) return false;
  std::vector<RingLink> way;
  std::vector<int> tasks;
  while (true) {
    tasks.push_back(task);
    const Waits waits = waits_of(task);
    const auto next = std::find_if(waits.awaited.begin(), waits.awaited.end(),
                                   [](const Awaited& awaited) { return !awaited.by.empty(); });
    if (next == waits.awaited.end()) break;
    way.push_back({task, *next});
    task = next->by.front();
    const auto again = std::find(tasks.begin(), tasks.end(), task);
    if (again == tasks.end()) continue;
    way.erase(way.begin(), way.begin() + (again - tasks.begin()));
    if (!lets_one_go_on(tasks)) reject_one_of(way);
    return true;
  }
  if (!lets_one_go_on(tasks)) rejection_ = Rejection{task, standstill_reason(task), {}};
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
