#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/robot/kinematics.hpp"
#include "src/simulation/schedule/time_text.hpp"
#include "src/simulation/taskplan/motion_task.hpp"
#include "src/simulation/taskplan/plan_calendars.hpp"
#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

namespace {

using Choice = interpreter::PoolSpec::Choice;

/// Whether the first of the ranks that differ by more than rounding is less.
bool is_less(const std::vector<double>& ranks, const std::vector<double>& others) {
  constexpr double kSame = 1e-6;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    const bool same = ranks[i] == others[i] || std::fabs(ranks[i] - others[i]) <= kSame;
    if (!same) return ranks[i] < others[i];
  }
  return false;
}

/// What the rule of a pool goes by, with the number it found.
std::string rank_text(Choice rule, double rank) {
  switch (rule) {
    case Choice::nearest:
      return std::isinf(rank) ? "without a way over its lanes" : fmt::format("{:.2f} m", rank);
    case Choice::least_used:
      return schedule::clock_text(static_cast<Ticks>(rank));
    case Choice::first:
      break;
  }
  return {};
}

}  // namespace

/// A task by pools asks for each choice that is left, and is given one.
void Simulation::ask(int task, Ticks from) {
  const double priority = stage_.spec(task).priority;
  if (!stage_.has_choices(task)) {
    stage_.allocator->ask(stage_.queue_of(task), task, priority, from);
    return;
  }
  const std::vector<int>& queues = stage_.choice_queues(task);
  for (std::size_t i = 0; i < queues.size(); ++i) {
    if (!is_out(task, static_cast<int>(i))) {
      stage_.allocator->ask(queues[i], task, priority, from);
    }
  }
}

/// Whether the task could not be done with these members, or has to have those of another task.
bool Simulation::is_out(int task, int choice) const {
  const interpreter::TaskSpec& spec = stage_.plan_spec(task);
  if (spec.same_as) {
    const auto& own = spec.choices[index(choice)].members;
    for (const interpreter::PoolMember& wanted : stage_.spec(*spec.same_as).members) {
      const bool has = std::any_of(own.begin(), own.end(), [&](const auto& member) {
        return member.pool == wanted.pool && member.member == wanted.member;
      });
      if (!has) return true;
    }
  }
  const auto failed = failed_choices_.find(task);
  if (failed == failed_choices_.end()) return false;
  return std::any_of(failed->second.begin(), failed->second.end(),
                     [&](const FailedChoice& each) { return each.choice == choice; });
}

bool Simulation::asks_no_more(int task, int queue) const {
  if (!stage_.has_choices(task)) return false;
  const std::vector<int>& queues = stage_.choice_queues(task);
  const auto place = std::find(queues.begin(), queues.end(), queue);
  if (place == queues.end()) return false;  // a crew for one of its works
  return records_.has_begun(task) || is_out(task, static_cast<int>(place - queues.begin()));
}

/// The least of the ranks, pool by pool; of equals the first in the order of the lists.
int Simulation::choose_queue(int task, const std::vector<int>& queues) const {
  int best = -1;
  std::vector<double> best_ranks;
  const std::vector<interpreter::TaskSpec>& choices = stage_.plan_spec(task).choices;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const int queue = stage_.choice_queues(task)[i];
    if (std::find(queues.begin(), queues.end(), queue) == queues.end()) continue;
    std::vector<double> ranks;
    for (const auto& member : choices[i].members) ranks.push_back(rank_of(choices[i], member));
    if (best >= 0 && !is_less(ranks, best_ranks)) continue;
    best = queue;
    best_ranks = std::move(ranks);
  }
  return best;
}

/// By the rule of its pool: the less, the sooner it is chosen.
double Simulation::rank_of(const interpreter::TaskSpec& choice,
                           const interpreter::PoolMember& member) const {
  const int resource = resource_of(plan_, member);
  switch (plan_.pools[index(member.pool)].choice) {
    case Choice::first:
      return member.member;
    case Choice::least_used:
      return static_cast<double>(stage_.allocator->state(resource).given_back);
    case Choice::nearest:
      break;
  }
  const bool moves = choice.move && stage_.site.stands(*choice.move);
  if (!moves && !choice.go) return 0;
  const auto goals =
      goals_of(plan_, choice, moves ? MotionPurpose::grip : MotionPurpose::go, stage_.site);
  const math::Vec3 p_WG = place_of(resource, goals.front());
  const auto over_lanes = stage_.site.lane_distance(resource, p_WG.head<2>());
  return over_lanes.value_or((p_WG - stage_.site.tool_pose(resource).translation()).norm());
}

/// Where the tool of the robot is at a goal (world).
math::Vec3 Simulation::place_of(int robot, const interpreter::GoalSpec& goal) const {
  if (goal.X_WG) return goal.X_WG->translation();
  const robot::RobotModel& model = stage_.robot_spec(robot).robot->model;
  const robot::Mounting& mounting = stage_.site.robot(robot).mounting;
  std::vector<double> q = stage_.site.configuration(robot);
  for (const auto& [parameter, value] : goal.values) q[index(parameter)] = value;
  robot::update_derived(model, mounting, q);
  return robot::tool_pose(model, mounting, q).translation();
}

/// The task has the members it was given; those of a group are kept for it.
void Simulation::take_members(const ResourceAllocator::Grant& grant) {
  const int task = grant.task;
  const std::vector<int>& queues = stage_.choice_queues(task);
  const auto place = std::find(queues.begin(), queues.end(), grant.queue);
  stage_.choose(task, static_cast<int>(place - queues.begin()));
  const int group = stage_.group_of(task);
  if (group < 0) return;
  for (const interpreter::PoolMember& member : stage_.spec(group).members) {
    stage_.allocator->reserve(resource_of(plan_, member), group);
  }
  // Whoever waits for these members waits for all of the group from now on.
  for (const int other : stage_.group(group)) stage_.begins_to_wait(other);
}

/// Who was chosen of each pool, and why.
std::string Simulation::choice_text(int task) const {
  const interpreter::TaskSpec& spec = stage_.spec(task);
  std::string text;
  for (const interpreter::PoolMember& member : spec.members) {
    const interpreter::PoolSpec& pool = plan_.pools[index(member.pool)];
    if (!text.empty()) text += "; ";
    text +=
        fmt::format("{} of {}: ", stage_.allocator->name(resource_of(plan_, member)), pool.name);
    if (spec.same_as) {
      text += fmt::format("the same as {}", stage_.spec(*spec.same_as).name);
      continue;
    }
    switch (pool.choice) {
      case Choice::first:
        text += "the first that is free";
        break;
      case Choice::nearest:
        text += "the nearest that is free, " + rank_text(pool.choice, rank_of(spec, member));
        break;
      case Choice::least_used:
        text += "the least used that is free, " + rank_text(pool.choice, rank_of(spec, member));
        break;
    }
    for (int other = 0; other < static_cast<int>(pool.members.size()); ++other) {
      if (other != member.member) text += text_of_other(task, {member.pool, other});
    }
  }
  return text;
}

/// Why not another member.
std::string Simulation::text_of_other(int task, const interpreter::PoolMember& other) const {
  const int resource = resource_of(plan_, other);
  const std::string& name = stage_.allocator->name(resource);
  const std::vector<interpreter::TaskSpec>& choices = stage_.plan_spec(task).choices;
  int choice = -1;  // the first with it
  for (std::size_t i = 0; choice < 0 && i < choices.size(); ++i) {
    for (const interpreter::PoolMember& each : choices[i].members) {
      if (each.pool == other.pool && each.member == other.member) choice = static_cast<int>(i);
    }
  }
  const auto failed = failed_choices_.find(task);
  if (failed != failed_choices_.end() && choices[index(choice)].members.size() == 1) {
    for (const FailedChoice& each : failed->second) {
      if (each.choice == choice) return fmt::format("; {} could not: {}", name, each.reason);
    }
  }
  const schedule::ResourceState& state = stage_.allocator->state(resource);
  if (state.holder() >= 0) {
    return fmt::format("; {} is in {}", name, stage_.spec(state.holder()).name);
  }
  if (state.reserved >= 0) {
    return fmt::format("; {} is kept for what has the same as {}", name,
                       stage_.spec(state.reserved).name);
  }
  if (!stage_.allocator->hours(resource).works_at(stage_.now())) {
    return fmt::format("; {} is out of shift", name);
  }
  const Choice rule = plan_.pools[index(other.pool)].choice;
  if (rule == Choice::first) return {};
  return fmt::format("; {} {}", name, rank_text(rule, rank_of(choices[index(choice)], other)));
}

/// A task by pools that is rejected with some members is tried with others; false if none are left,
/// or if it never got any: the rejection then has the cause of each.
bool Simulation::try_next_choice(Rejection& rejection) {
  const int task = rejection.task;
  if (!stage_.has_choices(task) || stage_.plan_spec(task).same_as) return false;
  const int choice = stage_.chosen(task);
  const std::vector<interpreter::TaskSpec>& choices = stage_.plan_spec(task).choices;
  bool is_left = false;
  if (choice >= 0) {
    failed_choices_[task].push_back({choice, rejection.reason, rejection.involved});
    for (int i = 0; i < static_cast<int>(choices.size()); ++i) is_left |= !is_out(task, i);
  }
  if (is_left) {
    if (checkpoints_.go_back(task, false)) {
      ask(task, stage_.now());
      stage_.begins_to_wait(task);
    } else {
      must_restart_ = true;
    }
    for (ParkingFailure& failure : parking_failed_) failure.last = -1;
    look_again_at_all();
    return true;
  }
  const auto failed = failed_choices_.find(task);
  if (failed == failed_choices_.end()) return false;
  std::string reason;
  for (const FailedChoice& each : failed->second) {
    if (!reason.empty()) reason += "; ";
    reason += interpreter::member_names(plan_, choices[index(each.choice)]) + ": " + each.reason;
    rejection.involved.insert(rejection.involved.end(), each.involved.begin(), each.involved.end());
  }
  if (choice < 0) reason += "; " + rejection.reason;
  rejection.reason = std::move(reason);
  return false;
}

}  // namespace rubicon::taskplan
