#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

namespace {

/// So many rejected tasks are let in again because a task that was in their way is not done either.
/// Each time costs a whole run; what comes later stays rejected.
constexpr std::size_t kMostSecondChances = 50;

}  // namespace

void Simulation::add_checkpoint(int task, std::vector<ResourceState> resources) {
  Checkpoint checkpoint;
  checkpoint.task = task;
  checkpoint.mark = journal_.mark();
  checkpoint.links = links_->mark();
  checkpoint.trace = buffer_ ? buffer_->mark() : 0;
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
  links_->forget_before(checkpoints_.empty() ? links_->mark() : checkpoints_.front().links);
  if (buffer_) {
    buffer_->release_before(checkpoints_.empty() ? buffer_->mark() : checkpoints_.front().trace);
  }
}

void Simulation::reject(const ActiveTask& active, std::string reason, std::vector<int> involved) {
  if (!rejection_) rejection_ = Rejection{active.task, std::move(reason), std::move(involved)};
}

/// The tasks, done or under way, that move or remove the component.
std::vector<int> Simulation::users_of(int component) const {
  std::vector<int> users;
  for (int i = 0; i < static_cast<int>(plan_.tasks.size()); ++i) {
    const interpreter::TaskSpec& task = spec(i);
    const bool removes =
        std::find(task.remove.begin(), task.remove.end(), component) != task.remove.end();
    const bool begun = status_[index(i)] == Status::active || status_[index(i)] == Status::done;
    if (begun && (removes || task.move == component)) users.push_back(i);
  }
  return users;
}

/// The tasks under way whose machines or components the task met.
std::vector<int> Simulation::in_the_way_of(const ActiveTask& active) const {
  std::vector<int> tasks;
  for (const auto& other : now_.active) {
    if (other->task == active.task) continue;
    const interpreter::TaskSpec& task = spec(other->task);
    const auto& met = active.hits.met();
    const bool machine = task.robot >= 0 && met.contains({task.robot, std::string()});
    if (machine || (task.move && met.contains({-1, site_.component_name(*task.move)}))) {
      tasks.push_back(other->task);
    }
  }
  return tasks;
}

/// Undoes a task that is to be rejected; false if there is none.
bool Simulation::apply_rejection() {
  if (!rejection_) return false;
  const Rejection rejection = *std::exchange(rejection_, std::nullopt);
  links_->drop_pending();
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
    if (buffer_) buffer_->set_kept(true);
    trace_end(task, outcome.start, outcome);
    if (buffer_) buffer_->set_kept(false);
    failed_parkings_.push_back(std::move(outcome));
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
  look_again_at_all();
  return true;
}

void Simulation::go_back(const Checkpoint& checkpoint) {
  const Checkpoint back = checkpoint;  // it is one of those that are dropped
  journal_.undo_to(back.mark);
  links_->undo_to(back.links);
  if (buffer_) buffer_->keep_only(back.trace, back.task);
  now_ = back.moment;
  allocator_->set_states(back.resources);
  site_.set_time(now_.now);
  for (int robot = 0; robot < static_cast<int>(plan_.robots.size()); ++robot) {
    site_.set_machine_state(robot, back.machines[index(robot)]);
  }
  const auto place = std::find_if(checkpoints_.begin(), checkpoints_.end(),
                                  [&](const Checkpoint& each) { return each.task == back.task; });
  checkpoints_.erase(place, checkpoints_.end());
}

void Simulation::exclude(int task, TaskOutcome outcome, int cause) {
  // A robot has made room for it before it began.
  if (std::find(asked_for_.begin(), asked_for_.end(), task) != asked_for_.end() &&
      second_chances_.size() < kMostSecondChances && second_chances_.emplace(task, task).second) {
    must_restart_ = true;
  }
  allocator_->exclude(task);
  std::erase_if(now_.zone_waits, [&](const ZoneWait& wait) { return wait.task == task; });
  if (buffer_) buffer_->set_kept(true);
  trace_end(task, outcome.start, outcome);
  if (buffer_) buffer_->set_kept(false);
  if (options_.on_task) {
    options_.on_task(++done_, static_cast<int>(plan_.tasks.size()), outcome);
  }
  ExcludedTask excluded{std::move(outcome), cause, {}, {}};
  if (buffer_ && task == cause) excluded.lines = buffer_->kept_of(task);
  excluded_.emplace(task, std::move(excluded));
  links_->leave_out(task);
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

/// The task, and all that comes after it.
std::set<int> Simulation::followers_of(int first) const {
  std::set<int> found = {first};
  std::vector<int> open = {first};
  while (!open.empty()) {
    const int task = open.back();
    open.pop_back();
    for (const auto& [follower, type] : links_->followers_of(task)) {
      if (found.insert(follower).second) open.push_back(follower);
    }
  }
  return found;
}

/// Who was rejected because of a task that is not done either might be done without that one: the
/// run begins anew without it, and finds out again about all that it has rejected on the way.
void Simulation::give_second_chances(int cause) {
  if (doubtful_.empty()) return;
  const std::set<int> without = followers_of(cause);
  std::set<int> let_in;
  for (const int task : doubtful_) {
    const auto rejected = excluded_.find(task);
    if (task == cause || rejected == excluded_.end()) continue;
    if (second_chances_.size() >= kMostSecondChances) break;
    for (const int other : rejected->second.involved) {
      if (!without.contains(other) || !excluded_.contains(other)) continue;
      if (!second_chances_.emplace(task, other).second) continue;
      let_in.insert(task);
      break;
    }
  }
  if (let_in.empty()) return;
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
    for (const auto& [follower, type] : links_->followers_of(task)) {
      if (excluded_.contains(follower)) continue;
      // Where the run begins anew nothing that starts after it has happened.
      const bool undone = must_restart_ && links_->waits_to_start(follower, type);
      if (!undone && status_[index(follower)] == Status::done) continue;
      ActiveTask* const active = find_active(follower);
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

/// A task that has begun is not held to its finish any more by a link from a task that is not done.
void Simulation::let_go(ActiveTask& active, int before, schedule::LinkType type) {
  if (!links_->let_go(active.task, before, type) || active.doing != Doing::held) return;
  const Ticks finish = links_->bounds_of(active.task, true).finish;
  if (finish < now_.now && active.since < now_.now) {
    // It has been held for nothing, and others may have waited for it.
    must_restart_ = true;
  } else {
    wake_at(active, std::max(now_.now, finish));
  }
}

}  // namespace rubicon::taskplan
