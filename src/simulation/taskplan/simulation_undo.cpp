#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

namespace {

/// So many rejected tasks are let in again because a task that was in their way is not done either.
/// Each time costs a whole run; what comes later stays rejected.
constexpr std::size_t kMostSecondChances = 50;

/// The task, and all that comes after it.
std::set<int> followers_of(const LinkState& links, int first) {
  std::set<int> found = {first};
  std::vector<int> open = {first};
  while (!open.empty()) {
    const int task = open.back();
    open.pop_back();
    for (const auto& [follower, type] : links.followers_of(task)) {
      if (found.insert(follower).second) open.push_back(follower);
    }
  }
  return found;
}

}  // namespace

/// Begins a lift again that is to wait for a shift into which it fits: the run goes back to before
/// its task, with a note. False if there is none.
bool Simulation::repeat_lift() {
  if (!stage_.lift_to_repeat) return false;
  const int task = *std::exchange(stage_.lift_to_repeat, std::nullopt);
  stage_.links->drop_pending();
  // What it asked for was given to it: it asks again.
  if (checkpoints_.go_back(task, false)) ask(task, stage_.now());
  stage_.lift_notes.forget_unless(
      [&](int other) { return other == task || records_.has_begun(other); });
  look_again_at_all();
  return true;
}

/// Undoes a task that is to be rejected; false if there is none.
bool Simulation::apply_rejection() {
  if (!stage_.rejection) return false;
  // What comes after the end of its shift does not happen to a lift that will be begun again.
  if (const auto overdue = overdue_lift(stage_)) {
    stage_.rejection.reset();
    repeat_overdue_lift(stage_, *overdue);
    if (!stage_.rejection) return repeat_lift();
  }
  Rejection rejection = *std::exchange(stage_.rejection, std::nullopt);
  stage_.links->drop_pending();
  if (try_next_choice(rejection)) return true;
  const int task = rejection.task;
  const interpreter::TaskSpec& each = stage_.spec(task);
  TaskOutcome outcome;
  if (ActiveTask* const active = stage_.active.find(task)) {
    outcome = std::move(active->account.outcome);
  } else {
    outcome.task = each.name;
    outcome.crews = crew_names(plan_, each);
    if (each.robot >= 0) outcome.robot = stage_.robot_spec(each.robot).name;
    outcome.start = stage_.now();
  }
  outcome.result = TaskResult::rejected;
  outcome.reason = rejection.reason;
  outcome.duration = outcome.motion_time = outcome.work_time = outcome.thinking = 0;
  outcome.holds.clear();
  outcome.lift.reset();
  outcome.waits = {};
  if (!checkpoints_.go_back(task, true) && stage_.active.look_at(task)) must_restart_ = true;
  stage_.lift_notes.forget_unless([&](int other) { return records_.has_begun(other); });
  if (stage_.is_park(task)) {
    ParkingFailure& failure = parking_failed_[index(task - stage_.plan_tasks())];
    failure.last = std::max(failure.last, stage_.now());
    ++failure.count;
    stage_.trace.keep([&] { trace_end(task, outcome.start, outcome); });
    stage_.failed_parkings.push_back(std::move(outcome));
    look_again_at_all();
    return true;
  }
  // Without it a robot may get to its park position.
  for (ParkingFailure& failure : parking_failed_) failure.last = -1;
  exclude(task, std::move(outcome), task);
  if (!rejection.involved.empty()) {
    excluded_.at(task).involved = rejection.involved;
    doubtful_.insert(task);
  }
  exclude_followers(task, task);
  give_second_chances(task);
  free_groups(true);
  look_again_at_all();
  // Those who dig and haul for each other have one less.
  stage_.announce({-1, -1, -1, true});
  return true;
}

void Simulation::exclude(int task, TaskOutcome outcome, int cause) {
  // A robot has made room for it before it began.
  const std::vector<int>& asked = records_.made_room_for();
  if (std::find(asked.begin(), asked.end(), task) != asked.end() &&
      second_chances_.size() < kMostSecondChances && second_chances_.emplace(task, task).second) {
    must_restart_ = true;
  }
  stage_.allocator->exclude(task);
  zone_waits_.erase(task);
  stage_.trace.keep([&] { trace_end(task, outcome.start, outcome); });
  if (options_.on_task) {
    options_.on_task(records_.count_one_for_good(), stage_.plan_tasks(), outcome);
  }
  ExcludedTask excluded{std::move(outcome), cause, {}, {}};
  if (task == cause) excluded.lines = stage_.trace.kept_of(task);
  excluded_.emplace(task, std::move(excluded));
  stage_.links->leave_out(task);
}

/// A task that could not begin: what it waits for is not done.
TaskOutcome Simulation::not_reached(int task, int missing) const {
  const interpreter::TaskSpec& each = stage_.spec(task);
  TaskOutcome outcome;
  outcome.task = each.name;
  if (each.robot >= 0) outcome.robot = stage_.robot_spec(each.robot).name;
  outcome.crews = crew_names(plan_, each);
  outcome.start = stage_.now();
  outcome.result = TaskResult::not_reached;
  const ExcludedTask& before = excluded_.at(missing);
  outcome.reason = fmt::format("it comes after {}, which is {}", before.outcome.task,
                               name_of(before.outcome.result));
  if (before.cause != missing) {
    outcome.reason += fmt::format(" because {} is {}", stage_.spec(before.cause).name,
                                  name_of(TaskResult::rejected));
  }
  return outcome;
}

/// Whether it digs for trucks with bodies none of which comes: it would only lose its reason.
bool Simulation::misses_all_trucks(int task) const {
  const interpreter::TaskSpec& spec = stage_.spec(task);
  if (!spec.motion_dig || !spec.motion_dig->loads_bodies()) return false;
  const std::vector<int>& haulers = spec.motion_dig->haulers;
  return std::all_of(haulers.begin(), haulers.end(),
                     [this](int hauler) { return excluded_.contains(hauler); });
}

/// Who was rejected because of a task that is not done either might be done without that one: the
/// run begins again without it, and finds out again about all that it has rejected on the way.
void Simulation::give_second_chances(int cause) {
  if (doubtful_.empty()) return;
  const std::set<int> without = followers_of(*stage_.links, cause);
  std::set<int> let_in;
  for (const int task : doubtful_) {
    const auto rejected = excluded_.find(task);
    if (task == cause || rejected == excluded_.end() || misses_all_trucks(task)) continue;
    if (second_chances_.size() >= kMostSecondChances) break;
    for (const int other : rejected->second.involved) {
      if (!without.contains(other) || !excluded_.contains(other)) continue;
      if (!second_chances_.emplace(task, other).second) continue;
      let_in.insert(task);
      break;
    }
  }
  if (let_in.empty()) return;
  for (const int task : let_in) failed_choices_.erase(task);
  must_restart_ = true;
  std::erase_if(excluded_, [&](const auto& each) {
    const int its_cause = each.second.cause;
    return its_cause != cause && (let_in.contains(its_cause) || !known_before_.contains(its_cause));
  });
  // What was not reached for its sake may come after others that are not done.
  std::vector<std::pair<int, int>> left;
  for (const auto& [task, excluded] : excluded_) left.emplace_back(task, excluded.cause);
  for (const auto& [task, its_cause] : left) exclude_followers(task, its_cause);
}

/// What depends on a task that is not done is not reached; a task that has begun and is only held
/// to its finish goes on without it.
void Simulation::exclude_followers(int first, int cause) {
  std::vector<int> open = {first};
  while (!open.empty()) {
    const int task = open.back();
    open.pop_back();
    std::vector<int> reached;
    for (const auto& [follower, type] : stage_.links->followers_of(task)) {
      if (excluded_.contains(follower)) continue;
      // Where the run begins again nothing that starts after it has happened.
      const bool undone = must_restart_ && stage_.links->waits_to_start(follower, task, type);
      if (!undone && records_.status(follower) == Status::done) continue;
      ActiveTask* const active = stage_.active.find(follower);
      if (active && !undone) {
        let_go(*active, task, type);
        continue;
      }
      exclude(follower, not_reached(follower, task), cause);
      reached.push_back(follower);
    }
    open.insert(open.end(), reached.rbegin(), reached.rend());
  }
}

/// What was kept for tasks that are all over is free for all from now on. If it was kept from
/// others for one that is not done, the run begins again without that one.
void Simulation::free_groups(bool rejected) {
  const int resources = stage_.robots() + static_cast<int>(plan_.crews.size());
  for (int resource = 0; resource < resources; ++resource) {
    const int group = stage_.allocator->state(resource).reserved;
    if (group < 0 || !stage_.group_is_over(group)) continue;
    const bool in_vain = rejected && kept_from_others(resource, group);
    stage_.allocator->keep_no_more(resource, stage_.now());
    if (!in_vain || second_chances_.size() >= kMostSecondChances) continue;
    const std::vector<int>& all = stage_.group(group);
    const auto out = std::count_if(all.begin(), all.end(),
                                   [this](int task) { return excluded_.contains(task); });
    must_restart_ |= second_chances_.emplace(group, -static_cast<int>(out)).second;
  }
}

/// Whether others may have had it since the last of the group that is done.
bool Simulation::kept_from_others(int resource, int group) const {
  Ticks since = 0;
  for (const int task : stage_.group(group)) {
    if (excluded_.contains(task)) continue;
    since = std::max(since, stage_.links->times(task).finish);
  }
  for (int task = 0; task < stage_.plan_tasks(); ++task) {
    if (stage_.group_of(task) == group || excluded_.contains(task)) continue;
    const bool began = records_.has_begun(task) && stage_.links->times(task).start >= since;
    // Where it is kept for no time others may yet have been given what the task asks for besides.
    const bool waited = records_.status(task) == Status::asking;
    if ((began || waited) && may_want(task, resource)) return true;
  }
  return false;
}

/// Whether the robot or crew is one of those that the task asks for, or may be.
bool Simulation::may_want(int task, int resource) const {
  const auto asks_for = [&](int queue) {
    const std::vector<int>& all = stage_.allocator->resources(queue);
    return std::find(all.begin(), all.end(), resource) != all.end();
  };
  // A machine's works may need any crew.
  if (stage_.spec(task).robot >= 0 && resource >= stage_.robots()) return true;
  const std::vector<int>& queues = stage_.choice_queues(task);
  return asks_for(stage_.queue_of(task)) || std::any_of(queues.begin(), queues.end(), asks_for);
}

/// A task that has begun is not held to its finish any more by a link from a task that is not done.
void Simulation::let_go(ActiveTask& active, int before, schedule::LinkType type) {
  if (!stage_.links->let_go(active.task, before, type) || !active.is_held()) return;
  const Ticks finish = stage_.links->bounds_of(active.task, true).finish;
  if (finish < stage_.now() && active.held_since < stage_.now()) {
    // It has been held for nothing, and others may have waited for it.
    must_restart_ = true;
  } else {
    stage_.events.set(active.task, std::max(stage_.now(), finish));
  }
}

}  // namespace rubicon::taskplan
