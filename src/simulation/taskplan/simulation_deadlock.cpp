#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

namespace {

std::string meeting(const Blocker& blocker) {
  return fmt::format("{} meets {}", blocker.moved, blocker.met);
}

}  // namespace

/// Tasks that wait for each other, so that none can ever go on: one of them is rejected. Seen as
/// soon as the last of them begins to wait.
bool Simulation::find_deadlock() {
  if (new_waits_.empty()) return false;
  const Deadlocked deadlocked =
      deadlocked_from(std::exchange(new_waits_, {}), [this](int task) { return waits_of(task); });
  if (deadlocked.empty()) return false;
  std::vector<int> tasks;
  for (const auto& [task, waits] : deadlocked) tasks.push_back(task);
  if (!lets_one_go_on(tasks)) reject_one_of(cycle_in(deadlocked));
  return true;
}

/// Rejects a task of a cycle, one without which the task before it could go on.
void Simulation::reject_one_of(const WaitCycle& cycle) {
  const std::string text =
      text_of(cycle, [this](const WaitLink& link) { return text_of_wait(link); });
  rejection_ = Rejection{last_of(helpful_in(cycle)), text, tasks_of(cycle)};
}

std::string Simulation::who_is(int task) const {
  const int robot = spec(task).robot;
  return robot >= 0 ? fmt::format("{} ({})", robot_spec(robot).name, spec(task).name)
                    : spec(task).name;
}

/// For whom a task waits that stands in its way, and where they meet.
std::string Simulation::text_of_way(int task, const Blocker& blocker) const {
  if (blocker.robot < 0) {
    return fmt::format("{} waits for the people of {}: {}", who_is(task),
                       spec(blocker.zone_task).name, meeting(blocker));
  }
  return fmt::format("{} waits for {}: {}", who_is(task), robot_spec(blocker.robot).name,
                     meeting(blocker));
}

/// Who waits for whom, and where.
std::string Simulation::text_of_wait(const WaitLink& wait) const {
  const auto& [task, target] = wait;
  const std::string who = who_is(task);
  const std::string& other = spec(target.by.front()).name;
  const bool stays = target.idle;
  const auto idle = [&](int which) {
    std::string text = fmt::format(", and {} moves only in {}", robot_spec(which).name, other);
    if (!robot_spec(which).park) text += ": give it a park position";
    return stays ? text : std::string();
  };
  switch (target.kind) {
    case WaitTarget::Kind::activity: {
      const Blocker& blocker = look_at_active(task)->blockers[index(target.number)];
      return text_of_way(task, blocker) + (blocker.robot >= 0 ? idle(blocker.robot) : "");
    }
    case WaitTarget::Kind::zone:
      return fmt::format("{} waits until {} has left its zone{}", who,
                         robot_spec(target.number).name, idle(target.number));
    case WaitTarget::Kind::resource:
      return fmt::format("{} waits for {}, which {} holds", who, allocator_->name(target.number),
                         other);
    case WaitTarget::Kind::start:
    case WaitTarget::Kind::finish:
      break;
  }
  const schedule::Link& link = links_->links_of(task)[index(target.number)];
  const bool starts = end_before(link.type) == schedule::TaskEnd::start;
  return fmt::format("{} does not {} until {} has {}", who,
                     target.kind == WaitTarget::Kind::start ? "start" : "finish", other,
                     starts ? "started" : "finished");
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
    propagate();
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
  const WaitWalk walk = walk_from(task, [this](int each) { return waits_of(each); });
  if (lets_one_go_on(walk.tasks)) return true;
  if (!walk.cycle.empty()) {
    reject_one_of(walk.cycle);
  } else {
    const int last = walk.tasks.back();
    rejection_ = Rejection{last, standstill_reason(last), {}};
  }
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
    const int holder = allocator_->state(active->crew).holder;
    return fmt::format("it never gets {}, which {} holds", allocator_->name(active->crew),
                       holder >= 0 ? spec(holder).name : std::string("nobody"));
  }
  return "its links never let it finish";
}

}  // namespace rubicon::taskplan
