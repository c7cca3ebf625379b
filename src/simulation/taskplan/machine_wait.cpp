#include "src/simulation/taskplan/machine_wait.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rubicon::taskplan {

namespace {

std::string meeting(const Blocker& blocker) {
  if (blocker.turn) return fmt::format("it {} {}", blocker.moved, blocker.met);
  return fmt::format("{} meets {}", blocker.moved, blocker.met);
}

}  // namespace

std::vector<Blocker> blockers_of(const std::vector<RecordedHit>& hits) {
  std::vector<Blocker> blockers;
  for (const RecordedHit& hit : hits) {
    if (!hit.pair.may_leave()) continue;
    Blocker blocker = Blocker::of(hit.pair);
    blocker.time = hit.time;
    const auto known = std::find_if(blockers.begin(), blockers.end(),
                                    [&](const Blocker& other) { return other.same_as(blocker); });
    if (known == blockers.end()) {
      blockers.push_back(blocker);
    } else {
      known->time = std::max(known->time, hit.time);
    }
  }
  return blockers;
}

namespace {

const site::MovingThing& moving_of(const Stage& stage, const Blocker& blocker) {
  return stage.site.moving(blocker.moving);
}

/// Whose machine, if any, holds up something with a timetable: -1 for none. Such things may wait
/// for each other; that ends with the first one met again.
int machine_before(const Stage& stage, int moving) {
  for (int i = 0; i <= stage.site.movings() && moving >= 0; ++i) {
    const auto& stop = stage.site.moving(moving).state().stop;
    if (!stop) return -1;
    if (stop->machine >= 0) return stop->machine;
    moving = stop->moving;
  }
  return -1;
}

std::string text_of_stop(const Stage& stage, const Blocker& blocker) {
  const auto& stop = moving_of(stage, blocker).state().stop;
  return stop ? fmt::format(", and {} waits for {}", moving_of(stage, blocker).name(), stop->by)
              : std::string();
}

}  // namespace

bool has_gone(const Stage& stage, const Blocker& blocker) {
  if (blocker.zone_task >= 0) return !stage.active.look_at(blocker.zone_task);
  if (blocker.moving >= 0) return moving_of(stage, blocker).is_gone(stage.now());
  if (blocker.robot < 0 || blocker.turn) return false;
  return !stage.active.look_at(stage.allocator->state(blocker.robot).holder()) &&
         stage.site.changed_at(blocker.robot) > blocker.time;
}

std::string text_of_way(const Stage& stage, int task, const Blocker& blocker) {
  if (blocker.moving >= 0) {
    return fmt::format("{} waits for {}: {}{}", stage.who_is(task),
                       moving_of(stage, blocker).name(), meeting(blocker),
                       text_of_stop(stage, blocker));
  }
  if (blocker.robot < 0) {
    return fmt::format("{} waits for the people of {}: {}", stage.who_is(task),
                       stage.spec(blocker.zone_task).name, meeting(blocker));
  }
  return fmt::format("{} waits for {}: {}", stage.who_is(task),
                     stage.robot_spec(blocker.robot).name, meeting(blocker));
}

WaitSet MachineWait::waits(const Stage& stage, int own) const {
  constexpr auto kKind = WaitTarget::Kind::activity;
  WaitSet waits;
  waits.any = true;
  for (std::size_t i = 0; i < blockers.size(); ++i) {
    const Blocker& blocker = blockers[i];
    const int number = static_cast<int>(i);
    if (blocker.moving >= 0) {
      const int robot = machine_before(stage, blocker.moving);
      waits.targets.push_back(robot >= 0 ? stage.move_of(robot, kKind, number)
                                         : WaitTarget{kKind, number, {}, false, false});
      continue;
    }
    waits.targets.push_back(blocker.robot >= 0
                                ? stage.move_of(blocker.robot, kKind, number)
                                : WaitTarget{kKind, number, {blocker.zone_task}, false, false});
    if (!blocker.turn) continue;
    // Any that drives on the network, or is at work there, may make room when it goes on.
    for (const int robot : stage.site.robots_beside(blocker.robot)) {
      if (robot == own || stage.allocator->state(robot).holder() < 0) continue;
      waits.targets.push_back(stage.move_of(robot, kKind, number));
    }
  }
  return waits;
}

bool MachineWait::wakes_at(const Stage& stage, const SiteEvent& event) const {
  const bool turn = std::any_of(blockers.begin(), blockers.end(),
                                [](const Blocker& blocker) { return blocker.turn; });
  if (turn && stage.site.traffic_changes() != traffic) return true;
  const bool met = std::any_of(blockers.begin(), blockers.end(), [&](const Blocker& blocker) {
    return (event.robot >= 0 && blocker.robot == event.robot && !blocker.turn) ||
           (event.moving >= 0 && blocker.moving == event.moving) ||
           (event.zone_task >= 0 && blocker.zone_task == event.zone_task);
  });
  return met && !(stubborn && progress_of(stage, blockers) == others);
}

std::vector<int> MachineWait::robots(const Stage& stage) const {
  std::vector<int> robots;
  for (const Blocker& blocker : blockers) {
    robots.push_back(blocker.moving >= 0 ? machine_before(stage, blocker.moving) : blocker.robot);
  }
  return robots;
}

void MachineWait::wait_for_timetables(Stage& stage, int task) const {
  const bool any = std::any_of(blockers.begin(), blockers.end(),
                               [](const Blocker& each) { return each.moving >= 0; });
  if (!any) return;
  stage.begins_to_wait(task);
  if (stage.now() >= stage.site.movings_worth_waiting()) return;
  Ticks next = schedule::kEndOfTime;
  for (const Blocker& blocker : blockers) {
    if (blocker.moving < 0 || moving_of(stage, blocker).state().stop) continue;
    const site::MovingThing& moving = moving_of(stage, blocker);
    next = std::min({next, moving.next_window(stage.now()), moving.last_time()});
  }
  if (next < schedule::kEndOfTime) stage.events.set(task, std::max(next, stage.now() + 1));
}

void MachineWait::note_wait(Stage& stage, int task) const {
  const Blocker& first = blockers.front();
  if (stage.now() <= since) return;
  if (first.moving >= 0) {
    const site::MovingThing& moving = moving_of(stage, first);
    schedule::MidWait wait{stage.now(), schedule::Held::timetable};
    wait.thing = moving.name();
    wait.delayed = moving.state().delay > 0;
    stage.links->add_mid_wait(task, std::move(wait));
    return;
  }
  const int holder = first.robot >= 0 ? stage.allocator->state(first.robot).last : first.zone_task;
  stage.links->add_mid_wait(
      task, {stage.now(), schedule::Held::machine, first.robot, holder, stage.parking_of(holder)});
}

std::string MachineWait::standstill_reason(const Stage& stage, int own) const {
  Blocker blocker = blockers.front();
  if (blocker.moving >= 0) {
    const std::string stop = text_of_stop(stage, blocker);
    return fmt::format(
        "blocked for ever: {}{}", meeting(blocker),
        stop.empty() ? ", which comes by again and again, and no machine moves" : stop);
  }
  if (blocker.turn) {
    // The first on its way could perhaps go, and another one behind it cannot.
    const auto bars = stage.site.who_bars(own, stage.idle_robots());
    if (bars) blocker = Blocker::of(*bars);
  }
  std::string reason =
      blocker.turn
          ? fmt::format("blocked for ever: {} is at {} and does not move any more",
                        stage.robot_spec(blocker.robot).name, blocker.met)
          : fmt::format("blocked for ever: {}, which does not move any more", meeting(blocker));
  if (blocker.robot < 0) return reason;
  const char* before_park = "; give";
  for (int task = 0; !blocker.turn && task < stage.plan_tasks(); ++task) {
    const interpreter::TaskSpec& each = stage.spec(task);
    if (each.robot != blocker.robot || !stage.allocator->is_excluded(task)) continue;
    // Often the two were in each other's way, and the other is done without this one in the end.
    reason += fmt::format(
        ", as {} was left out; where {} is done without this task, let this one come after it",
        each.name, each.name);
    before_park = ", or give";
    break;
  }
  const interpreter::RobotSpec& robot = stage.robot_spec(blocker.robot);
  if (!robot.park) reason += fmt::format("{} {} a park position", before_park, robot.name);
  return reason;
}

std::string MachineWait::first_name(const Stage& stage) const {
  const Blocker& first = blockers.front();
  if (first.moving >= 0) return moving_of(stage, first).name();
  return first.robot >= 0 ? stage.robot_spec(first.robot).name
                          : "the zone of " + stage.spec(first.zone_task).name;
}

std::uint64_t progress_of(const Stage& stage, const std::vector<Blocker>& blockers) {
  std::uint64_t sum = 0;
  for (const Blocker& blocker : blockers) {
    if (blocker.moving >= 0) {
      sum = sum * 1'000'003 + stage.site.movings_gone_on();
      continue;
    }
    const int task =
        blocker.robot >= 0 ? stage.allocator->state(blocker.robot).holder() : blocker.zone_task;
    const ActiveTask* const other = stage.active.look_at(task);
    sum = sum * 1'000'003 + static_cast<std::uint64_t>(task + 2) * 65'537 +
          (other ? other->account.progress + 1 : 0);
  }
  return sum;
}

}  // namespace rubicon::taskplan
