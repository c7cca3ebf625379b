#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/taskplan/simulation.hpp"

namespace rubicon::taskplan {

namespace {

/// So often a run begins anew because a ring may be none without a task that is not done. Each time
/// costs a whole run; what comes later stays rejected.
constexpr std::size_t kMostSecondChances = 50;

}  // namespace

void Simulation::add_checkpoint(int task, std::vector<ResourceState> resources) {
  Checkpoint checkpoint;
  checkpoint.task = task;
  checkpoint.mark = journal_.mark();
  checkpoint.trace = tape_ ? tape_->mark() : 0;
  checkpoint.moment = now_;
  checkpoint.resources = std::move(resources);
  std::erase_if(checkpoint.moment.zone_waits,
                [&](const ZoneWait& wait) { return wait.task == task; });
  for (int robot = 0; robot < static_cast<int>(plan_.robots.size()); ++robot) {
    checkpoint.machines.push_back(site_.machine_state(robot));
  }
  checkpoints_.push_back(std::move(checkpoint));
}

void Simulation::drop_checkpoint(int task) {
  std::erase_if(checkpoints_,
                [&](const Checkpoint& checkpoint) { return checkpoint.task == task; });
  journal_.forget_before(checkpoints_.empty() ? journal_.mark() : checkpoints_.front().mark);
  if (tape_) {
    tape_->release_before(checkpoints_.empty() ? tape_->mark() : checkpoints_.front().trace);
  }
}

void Simulation::reject(const ActiveTask& active, std::string reason) {
  if (!rejection_) rejection_ = Rejection{active.task, std::move(reason), {}};
}

/// Undoes a task that is to be rejected; false if there is none.
bool Simulation::apply_rejection() {
  if (!rejection_) return false;
  const Rejection rejection = *std::exchange(rejection_, std::nullopt);
  news_.clear();
  const int task = rejection.task;
  const auto checkpoint = std::find_if(checkpoints_.begin(), checkpoints_.end(),
                                       [&](const Checkpoint& each) { return each.task == task; });
  TaskOutcome outcome;
  if (ActiveTask* const active = find_active(task)) {
    outcome = std::move(active->outcome);
  } else {
    outcome.task = spec(task).name;
    outcome.crews = crew_names(plan_, spec(task));
    if (spec(task).robot >= 0) outcome.robot = robot_spec(spec(task).robot).name;
    outcome.start = now_.now;
  }
  outcome.result = TaskResult::rejected;
  outcome.reason = rejection.reason;
  outcome.duration = outcome.motion_time = outcome.work_time = 0;
  outcome.holds.clear();
  outcome.waits = {};
  if (checkpoint != checkpoints_.end()) {
    go_back(*checkpoint);
  } else if (find_active(task)) {
    must_restart_ = true;
  }
  if (is_park(task)) {
    ParkingFailure& failure = parking_failed_[index(task) - plan_.tasks.size()];
    failure.last = std::max(failure.last, now_.now);
    ++failure.count;
    if (tape_) tape_->set_kept(true);
    trace_end(task, outcome.start, outcome);
    if (tape_) tape_->set_kept(false);
    failed_parkings_.push_back(std::move(outcome));
    look_again_at_all();
    return true;
  }
  // Without it a robot may get to its park position.
  for (ParkingFailure& failure : parking_failed_) failure.last = -1;
  exclude(task, std::move(outcome), task);
  if (!rejection.ring.empty()) {
    excluded_.at(task).ring = rejection.ring;
    ring_victims_.insert(task);
  }
  exclude_followers(task);
  give_second_chances(task);
  look_again_at_all();
  return true;
}

void Simulation::go_back(const Checkpoint& checkpoint) {
  const Checkpoint back = checkpoint;  // it is one of those that are dropped
  journal_.undo_to(back.mark);
  if (tape_) tape_->keep_only(back.trace, back.task);
  now_ = back.moment;
  desk_->set_states(back.resources);
  site_.set_time(now_.now);
  for (int robot = 0; robot < static_cast<int>(plan_.robots.size()); ++robot) {
    site_.set_machine_state(robot, back.machines[index(robot)]);
  }
  const auto place = std::find_if(checkpoints_.begin(), checkpoints_.end(),
                                  [&](const Checkpoint& each) { return each.task == back.task; });
  checkpoints_.erase(place, checkpoints_.end());
}

void Simulation::exclude(int task, TaskOutcome outcome, int cause) {
  desk_->exclude(task);
  std::erase_if(now_.zone_waits, [&](const ZoneWait& wait) { return wait.task == task; });
  if (tape_) tape_->set_kept(true);
  trace_end(task, outcome.start, outcome);
  if (tape_) tape_->set_kept(false);
  if (options_.on_task) {
    options_.on_task(++done_, static_cast<int>(plan_.tasks.size()), outcome);
  }
  ExcludedTask excluded{std::move(outcome), cause, {}, {}};
  if (tape_ && task == cause) excluded.lines = tape_->kept_of(task);
  excluded_.emplace(task, std::move(excluded));
}

/// A task that could not begin: what it waits for is not done.
TaskOutcome Simulation::not_reached(int task, int missing) const {
  const interpreter::TaskSpec& each = spec(task);
  TaskOutcome outcome;
  outcome.task = each.name;
  if (each.robot >= 0) outcome.robot = robot_spec(each.robot).name;
  outcome.crews = crew_names(plan_, each);
  outcome.start = now_.now;
  outcome.result = TaskResult::not_reached;
  const ExcludedTask& before = excluded_.at(missing);
  outcome.reason = fmt::format("it comes after {}, which is {}", before.outcome.task,
                               name_of(before.outcome.result));
  if (before.cause != missing) {
    outcome.reason +=
        fmt::format(" because {} is {}", spec(before.cause).name, name_of(TaskResult::rejected));
  }
  return outcome;
}

/// Without one of its tasks a ring is none: if another of them is not done either, the run begins
/// anew without that one, and with the task that was rejected for the ring.
void Simulation::give_second_chances(int cause) {
  std::vector<int> let_in;
  for (const int task : ring_victims_) {
    const auto victim = excluded_.find(task);
    if (task == cause || victim == excluded_.end()) continue;
    if (second_chances_.size() >= kMostSecondChances) break;
    for (const int other : victim->second.ring) {
      const auto gone = excluded_.find(other);
      if (gone == excluded_.end() || gone->second.cause != cause) continue;
      if (!second_chances_.emplace(task, other).second) continue;
      let_in.push_back(task);
      break;
    }
  }
  if (let_in.empty()) return;
  must_restart_ = true;
  std::erase_if(excluded_, [&](const auto& each) {
    return std::find(let_in.begin(), let_in.end(), each.second.cause) != let_in.end();
  });
}

/// What depends on a task that is not done is not reached; a task that has begun and is only held
/// to its finish goes on without it.
void Simulation::exclude_followers(int first) {
  std::vector<int> open = {first};
  while (!open.empty()) {
    const int task = open.back();
    open.pop_back();
    std::vector<int> reached;
    for (const auto& [follower, type] : followers_[index(task)]) {
      if (excluded_.contains(follower)) continue;
      // Where the run begins anew nothing that starts after it has happened.
      const bool undone = must_restart_ && end_after(type) == schedule::TaskEnd::start;
      if (!undone && status_[index(follower)] == Status::done) continue;
      ActiveTask* const active = find_active(follower);
      if (active && !undone) {
        let_go(*active, task, type);
        continue;
      }
      exclude(follower, not_reached(follower, task), first);
      reached.push_back(follower);
    }
    open.insert(open.end(), reached.rbegin(), reached.rend());
  }
}

/// A task that has begun is not held to its finish any more by a link from a task that is not done.
void Simulation::let_go(ActiveTask& active, int before, schedule::LinkType type) {
  const int event = end_before(type) == schedule::TaskEnd::start ? 1 : 2;
  const bool told = (known_[index(before)] & event) != 0;
  if (end_after(type) != schedule::TaskEnd::finish || told) return;
  if (--to_finish_[index(active.task)] > 0 || active.doing != Doing::held) return;
  const Ticks finish = bounds_of(active.task, true).finish;
  if (finish < now_.now && active.since < now_.now) {
    // It has been held for nothing, and others may have waited for it.
    must_restart_ = true;
  } else {
    wake_at(active, std::max(now_.now, finish));
  }
}

}  // namespace rubicon::taskplan
