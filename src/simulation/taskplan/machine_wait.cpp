#include "src/simulation/taskplan/machine_wait.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rubicon::taskplan {

namespace {

std::string meeting(const Blocker& blocker) {
  return fmt::format("{} meets {}", blocker.moved, blocker.met);
}

}  // namespace

std::vector<Blocker> blockers_of(const std::vector<RecordedHit>& hits) {
  std::vector<Blocker> blockers;
  for (const RecordedHit& hit : hits) {
    const Blocker blocker{hit.pair.machine, hit.pair.zone_task, hit.pair.moved, hit.pair.met};
    if (blocker.robot < 0 && blocker.zone_task < 0) continue;
    const bool known = std::any_of(blockers.begin(), blockers.end(),
                                   [&](const Blocker& other) { return other.same_as(blocker); });
    if (!known) blockers.push_back(blocker);
  }
  return blockers;
}

std::string text_of_way(const Stage& stage, int task, const Blocker& blocker) {
  if (blocker.robot < 0) {
    return fmt::format("{} waits for the people of {}: {}", stage.who_is(task),
                       stage.spec(blocker.zone_task).name, meeting(blocker));
  }
  return fmt::format("{} waits for {}: {}", stage.who_is(task),
                     stage.robot_spec(blocker.robot).name, meeting(blocker));
}

WaitSet MachineWait::waits(const Stage& stage) const {
  constexpr auto kKind = WaitTarget::Kind::activity;
  WaitSet waits;
  waits.any = true;
  for (std::size_t i = 0; i < blockers.size(); ++i) {
    const Blocker& blocker = blockers[i];
    const int number = static_cast<int>(i);
    waits.targets.push_back(blocker.robot >= 0
                                ? stage.move_of(blocker.robot, kKind, number)
                                : WaitTarget{kKind, number, {blocker.zone_task}, false, false});
  }
  return waits;
}

bool MachineWait::wakes_at(const Stage& stage, const SiteEvent& event) const {
  const bool met = std::any_of(blockers.begin(), blockers.end(), [&](const Blocker& blocker) {
    return (event.robot >= 0 && blocker.robot == event.robot) ||
           (event.zone_task >= 0 && blocker.zone_task == event.zone_task);
  });
  return met && !(stubborn && progress_of(stage, blockers) == others);
}

std::vector<int> MachineWait::robots() const {
  std::vector<int> robots;
  for (const Blocker& blocker : blockers) robots.push_back(blocker.robot);
  return robots;
}

std::string MachineWait::standstill_reason(const Stage& stage) const {
  const Blocker& blocker = blockers.front();
  std::string reason =
      fmt::format("blocked for ever: {}, which does not move any more", meeting(blocker));
  if (blocker.robot >= 0 && !stage.robot_spec(blocker.robot).park) {
    reason += fmt::format("; give {} a park position", stage.robot_spec(blocker.robot).name);
  }
  return reason;
}

std::string MachineWait::first_name(const Stage& stage) const {
  const Blocker& first = blockers.front();
  return first.robot >= 0 ? stage.robot_spec(first.robot).name
                          : "the zone of " + stage.spec(first.zone_task).name;
}

std::uint64_t progress_of(const Stage& stage, const std::vector<Blocker>& blockers) {
  std::uint64_t sum = 0;
  for (const Blocker& blocker : blockers) {
    const int task =
        blocker.robot >= 0 ? stage.allocator->state(blocker.robot).holder() : blocker.zone_task;
    const ActiveTask* const other = stage.active.look_at(task);
    sum = sum * 1'000'003 + static_cast<std::uint64_t>(task + 2) * 65'537 +
          (other ? other->account.progress + 1 : 0);
  }
  return sum;
}

}  // namespace rubicon::taskplan
