#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "src/motion/guides/vehicle.hpp"
#include "src/simulation/taskplan/goal_holds.hpp"
#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

/// What a task waits for that only other tasks can bring about; nothing for one that is over.
std::optional<WaitSet> Simulation::waits_of(int task) const {
  if (is_over(task)) return std::nullopt;
  WaitSet waits;
  const ActiveTask* const active = stage_.active.look_at(task);
  if (!active && records_.status(task) == Status::asking) {
    if (zone_waits_.find(task)) {
      const interpreter::TaskSpec& spec = stage_.spec(task);
      const auto robot = stage_.site.machine_in(zone_of(spec), spec.robot);
      if (robot) waits.targets.push_back(stage_.move_of(*robot, WaitTarget::Kind::zone, *robot));
    }
    if (stage_.has_choices(task)) {
      stage_.add_choices(waits, task);
    } else {
      for (const Share& share : stage_.allocator->shares(stage_.queue_of(task))) {
        stage_.add_resource(waits, task, share);
      }
    }
  } else if (!active) {
    add_links(waits, task, WaitTarget::Kind::start);
  } else if (stage_.events.is_set(task)) {
    return waits;
  } else if (active->activity) {
    return active->activity->waits(*active, stage_);
  } else if (active->is_held()) {
    add_links(waits, task, WaitTarget::Kind::finish);
  }
  return waits;
}

/// The links of a task whose event is not known yet.
void Simulation::add_links(WaitSet& waits, int task, WaitTarget::Kind kind) const {
  const auto end =
      kind == WaitTarget::Kind::start ? schedule::TaskEnd::start : schedule::TaskEnd::finish;
  for (const int link : stage_.links->open_links(task, end)) {
    const int before = stage_.links->links_of(task)[index(link)].task;
    if (!is_over(before)) waits.targets.push_back({kind, link, {before}, false, false});
  }
}

/// Those who wait for a robot that is given back now wait for whoever will have it next.
void Simulation::look_again_who_waits_for(int robot) {
  for (std::size_t i = 0; i < stage_.active.size(); ++i) {
    const ActiveTask& active = stage_.active[i];
    if (!active.activity) continue;
    const std::vector<int> robots = active.activity->robots_in_the_way(stage_);
    if (std::find(robots.begin(), robots.end(), robot) != robots.end()) {
      stage_.begins_to_wait(active.task);
    }
  }
  for (const ZoneWait& wait : zone_waits_.all()) {
    if (wait.robot == robot) stage_.begins_to_wait(wait.task);
  }
}

/// Some tasks are gone, and with them what others waited for.
void Simulation::look_again_at_all() {
  for (std::size_t i = 0; i < stage_.active.size(); ++i) {
    stage_.begins_to_wait(stage_.active[i].task);
  }
  for (const ZoneWait& wait : zone_waits_.all()) stage_.begins_to_wait(wait.task);
}

/// Tasks that wait for each other, so that none can ever go on: one of them is rejected. Seen as
/// soon as the last of them begins to wait.
bool Simulation::find_deadlock() {
  if (stage_.new_waits.empty()) return false;
  const Deadlocked deadlocked = deadlocked_from(std::exchange(stage_.new_waits, {}),
                                                [this](int task) { return waits_of(task); });
  if (deadlocked.empty()) return false;
  std::vector<int> tasks;
  for (const auto& [task, waits] : deadlocked) tasks.push_back(task);
  if (!lets_one_go_on(tasks)) reject_one_of(cycle_in(deadlocked));
  // Without that one there may be another cycle among them.
  for (const int task : tasks) stage_.begins_to_wait(task);
  return true;
}

/// Rejects a task of a cycle, one without which the task before it could go on: parking first, then
/// the least priority, of equals the last in the file.
void Simulation::reject_one_of(const WaitCycle& cycle) {
  const auto key = [&](int task) {
    return std::tuple(stage_.is_park(task), -stage_.spec(task).priority, task);
  };
  const std::vector<int> helpful = helpful_in(cycle);
  const int task = *std::max_element(helpful.begin(), helpful.end(),
                                     [&](int a, int b) { return key(a) < key(b); });
  const std::string text =
      text_of(cycle, [this](const WaitLink& link) { return text_of_wait(link); });
  stage_.rejection = Rejection{task, text, tasks_of(cycle)};
}

/// Who waits for whom, and where.
std::string Simulation::text_of_wait(const WaitLink& wait) const {
  const int task = wait.task;
  const WaitTarget& target = wait.target;
  const std::string who = stage_.who_is(task);
  const std::string& other = stage_.spec(target.by.front()).name;
  const auto idle = [&](int robot) {
    if (!target.idle) return std::string();
    const interpreter::RobotSpec& machine = stage_.robot_spec(robot);
    std::string text = fmt::format(", and {} moves only in {}", machine.name, other);
    if (!machine.park) text += ": give it a park position";
    return text;
  };
  switch (target.kind) {
    case WaitTarget::Kind::activity: {
      const ActiveTask& active = *stage_.active.look_at(task);
      std::string text = active.activity->text_of(active, stage_, target);
      if (target.idle) {
        text += idle(active.activity->robots_in_the_way(stage_)[index(target.number)]);
      }
      return text;
    }
    case WaitTarget::Kind::zone:
      return fmt::format("{} waits until {} has left its zone{}", who,
                         stage_.robot_spec(target.number).name, idle(target.number));
    case WaitTarget::Kind::resource:
      return fmt::format("{} waits for {}, which {} holds", who,
                         stage_.allocator->name(target.number), other);
    case WaitTarget::Kind::kept:
      return fmt::format("{} waits for {}, which is kept for {}", who,
                         stage_.allocator->name(target.number), other);
    case WaitTarget::Kind::start:
    case WaitTarget::Kind::finish:
      break;
  }
  const schedule::Link& link = stage_.links->links_of(task)[index(target.number)];
  const bool starts = end_before(link.type) == schedule::TaskEnd::start;
  return fmt::format("{} does not {} until {} has {}", who,
                     target.kind == WaitTarget::Kind::start ? "start" : "finish", other,
                     starts ? "started" : "finished");
}

/// Of tasks that wait for ever, one that has reached enough goes on as it is; false if there is
/// none.
bool Simulation::lets_one_go_on(const std::vector<int>& tasks) {
  for (const int task : tasks) {
    ActiveTask* const active = stage_.active.find(task);
    if (!active || !active->activity || !active->activity->settle(*active, stage_)) continue;
    go_on(*active, Step::over);
    propagate();
    return true;
  }
  return false;
}

/// Nothing will happen any more, but some tasks have not finished: the one that the others wait for
/// is rejected. False if all have finished.
bool Simulation::resolve_standstill() {
  int task = -1;
  if (!stage_.active.empty()) task = stage_.active[0].task;
  for (int i = 0; task < 0 && i < stage_.plan_tasks(); ++i) {
    if (!is_over(i)) task = i;
  }
  if (task < 0) return false;
  const WaitWalk walk = walk_from(task, [this](int each) { return waits_of(each); });
  if (lets_one_go_on(walk.tasks)) return true;
  if (!walk.cycle.empty()) {
    reject_one_of(walk.cycle);
  } else {
    // What is over is waited for in vain; who waits for it is to go.
    const auto last = std::find_if(walk.tasks.rbegin(), walk.tasks.rend(),
                                   [this](int each) { return !is_over(each); });
    const int rejected = last == walk.tasks.rend() ? task : *last;
    stage_.rejection = Rejection{rejected, standstill_reason(rejected), {}};
  }
  return true;
}

std::string Simulation::standstill_reason(int task) const {
  if (const ZoneWait* const zone = zone_waits_.find(task)) {
    return fmt::format("{} stands in its zone and does not move any more",
                       stage_.robot_spec(zone->robot).name);
  }
  const ActiveTask* const active = stage_.active.look_at(task);
  if (!active) return "no shift of all that it needs ever begins";
  std::string reason;
  if (active->activity) reason = active->activity->standstill_reason(*active, stage_);
  return reason.empty() ? "its links never let it finish" : reason;
}

/// Whether an idle robot may be asked to its park position: now, or some day.
bool Simulation::may_park(int robot, bool now) const {
  const interpreter::RobotSpec& machine = stage_.robot_spec(robot);
  const ParkingFailure& failure = parking_failed_[index(robot)];
  // Where it could not go it is asked again later, but not for ever.
  if (!machine.park || failure.count >= kMostParkings) return false;
  if (now && stage_.now() <= failure.last) return false;
  if (now && (stage_.allocator->state(robot).holder() >= 0 || stage_.site.load(robot)))
    return false;
  if (now && stage_.breakdowns.out_until(robot) > stage_.now()) return false;
  return !goal_holds(machine.robot->model, stage_.site.robot(robot).mounting,
                     stage_.site.configuration(robot), *stage_.spec(stage_.park_task(robot)).go,
                     {});
}

/// Where the tasks lead that a robot has yet to finish, or may be chosen for (world, m).
std::vector<Eigen::Vector2d> Simulation::places_ahead(int robot) const {
  std::vector<Eigen::Vector2d> places;
  const auto add = [&](const math::Vec3& p_W) { places.emplace_back(p_W.head<2>()); };
  const auto add_task = [&](const interpreter::TaskSpec& task) {
    if (task.robot != robot) return;
    for (const interpreter::GoalSpec& goal : task.via) add(place_of(robot, goal));
    if (task.go) add(place_of(robot, *task.go));
    if (task.move) {
      const math::Pose& X_OG = plan_.components[index(*task.move)].X_OG;
      if (stage_.site.stands(*task.move)) add((stage_.site.X_WO(*task.move) * X_OG).translation());
      add((task.X_WO_goal * X_OG).translation());
    }
    if (!task.haul) return;
    for (const int dig : task.haul->digs) {
      const auto& loads = stage_.spec(dig).motion_dig;
      if (loads && loads->loads_bodies()) add(loads->X_WL->translation());
    }
    for (const math::Pose& X_WT : task.haul->tips) add(X_WT.translation());
  };
  for (const int task : stage_.tasks_of(robot)) {
    if (is_over(task)) continue;
    if (stage_.has_choices(task) && stage_.chosen(task) < 0) {
      for (const interpreter::TaskSpec& choice : stage_.plan_spec(task).choices) add_task(choice);
    } else {
      add_task(stage_.spec(task));
    }
  }
  return places;
}

/// Where vehicles of fleets stand in each other's way, those that wait or are idle get out of it.
bool Simulation::untangle_fleets() {
  if (plan_.fleets.empty()) return false;
  const std::vector<bool> idle = stage_.idle_robots();
  const auto ahead = [this](int robot) { return places_ahead(robot); };
  bool any = false;
  for (std::size_t i = 0; i < stage_.active.size(); ++i) {
    const ActiveTask& active = stage_.active[i];
    const int robot = stage_.spec(active.task).robot;
    if (!active.activity || robot < 0 || stage_.robot_spec(robot).fleet < 0) continue;
    if (active.activity->robots_in_the_way(stage_).empty()) continue;
    if (!stage_.site.untangle(robot, idle, ahead)) continue;
    any = true;
    stage_.announce({robot, -1});
  }
  return any;
}

/// An idle vehicle of a fleet that has a way goes to its end, if need be in two drives.
void Simulation::choose_park(int robot) {
  const interpreter::RobotSpec& machine = stage_.robot_spec(robot);
  const auto node = stage_.site.next_stop(robot);
  if (machine.fleet < 0 || !node || stage_.allocator->state(robot).holder() >= 0) return;
  const math::Pose X_WN =
      math::translation(node->x, node->y, 0) * math::rotation_z_deg(node->heading_deg);
  stage_.set_park(robot, guides::values_at(machine.robot->model, stage_.site.robot(robot).mounting,
                                           stage_.site.configuration(robot), X_WN));
}

/// Asks idle machines that are in somebody's way to their park position; whether one was asked.
bool Simulation::park_idle_machines() {
  std::vector<std::pair<int, int>> in_the_way;  // the robot, the task that waits for it
  for (std::size_t i = 0; i < stage_.active.size(); ++i) {
    const ActiveTask& active = stage_.active[i];
    if (!active.activity) continue;
    for (const int robot : active.activity->robots_in_the_way(stage_)) {
      in_the_way.emplace_back(robot, active.task);
    }
  }
  for (const ZoneWait& wait : zone_waits_.all()) in_the_way.emplace_back(wait.robot, wait.task);
  for (const auto& [robot, asking] : in_the_way) {
    if (robot < 0) continue;
    choose_park(robot);
    if (!may_park(robot, true)) continue;
    const int task = stage_.park_task(robot);
    ResourceAllocator::Grant grant;
    grant.task = task;
    grant.queue = stage_.queue_of(task);
    grant.before = stage_.allocator->mark();
    const schedule::ResourceState::Free last = stage_.allocator->state(robot).free.front();
    stage_.allocator->take_directly({robot, 1}, task);
    schedule::TaskTimes times;
    times.ready = times.wanted = stage_.now();
    times.held = schedule::Held::asked;
    times.task_before = asking;
    times.given_back_midway = true;
    // Asked for while another task had it: it goes when that gives it back.
    const ZoneWait* const zone = zone_waits_.find(asking);
    const bool came_free = zone ? last.since > zone->since : last.since == stage_.now();
    if (came_free && last.task_before >= 0) {
      hold_until_free(times, {robot, last.task_before, last.since, last.midway, false});
    }
    stage_.links->set_times(task, times);
    stage_.links->forget_known(task);
    begin_task(grant);
    records_.made_room_for(asking);
    propagate();
    return true;
  }
  return false;
}

}  // namespace rubicon::taskplan
