#include "src/simulation/taskplan/precomputed_times.hpp"

#include <algorithm>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/simulation/taskplan/plan_calendars.hpp"

namespace rubicon::taskplan {

namespace {

using math::at;

/// Which tasks can be precomputed: none of the others, and whatever these keep from being so.
std::vector<bool> precomputable(const interpreter::PlanModel& plan,
                                const std::vector<schedule::NetworkTask>& tasks) {
  std::vector<bool> result(tasks.size(), true);
  std::vector<std::vector<int>> followers(tasks.size());
  std::vector<std::vector<int>> users(plan.robots.size() + plan.crews.size());
  std::vector<int> open;
  const auto rule_out = [&](int task) {
    if (!result[at(task)]) return;
    result[at(task)] = false;
    open.push_back(task);
  };
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const int task = static_cast<int>(i);
    for (const schedule::Link& link : tasks[i].after) followers[at(link.task)].push_back(task);
    for (const int resource : tasks[i].resources) users[at(resource)].push_back(task);
    const interpreter::TaskSpec& spec = plan.tasks[i];
    const bool chosen = !spec.choices.empty();
    if (spec.robot >= 0 || chosen || !spec.zones.empty() || !spec.remove.empty()) rule_out(task);
    // Crews that a robot's task needs for a work only.
    for (const auto* const work : {&spec.hook, &spec.adjust, &spec.release}) {
      if (*work && (*work)->crew >= 0)
        users[plan.robots.size() + at((*work)->crew)].push_back(task);
    }
    for (const interpreter::WorkSpec& work : spec.takes) {
      if (work.crew >= 0) users[plan.robots.size() + at(work.crew)].push_back(task);
    }
  }
  // What a pool may give to somebody cannot be precomputed for others.
  std::vector<std::vector<int>> may_have(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    for (const interpreter::TaskSpec& choice : plan.tasks[i].choices) {
      for (const int resource : held_resources(plan, choice)) may_have[i].push_back(resource);
    }
  }
  const auto rule_out_users = [&](std::vector<int>& of) {
    for (const int user : of) rule_out(user);
    of.clear();
  };
  while (!open.empty()) {
    const int task = open.back();
    open.pop_back();
    for (const int follower : followers[at(task)]) rule_out(follower);
    for (const int resource : tasks[at(task)].resources) rule_out_users(users[at(resource)]);
    for (const int resource : may_have[at(task)]) rule_out_users(users[at(resource)]);
    const interpreter::TaskSpec& spec = plan.tasks[at(task)];
    for (const auto* const work : {&spec.hook, &spec.adjust, &spec.release}) {
      if (!*work || (*work)->crew < 0) continue;
      rule_out_users(users[plan.robots.size() + at((*work)->crew)]);
    }
    for (const interpreter::WorkSpec& work : spec.takes) {
      if (work.crew >= 0) rule_out_users(users[plan.robots.size() + at(work.crew)]);
    }
  }
  return result;
}

}  // namespace

std::vector<std::optional<schedule::TaskTimes>> precomputed_times(
    const interpreter::PlanModel& plan, const std::vector<schedule::NetworkTask>& tasks,
    const interpreter::Draws& draws) {
  std::vector<std::optional<schedule::TaskTimes>> result(tasks.size());
  const std::vector<bool> chosen = precomputable(plan, tasks);
  std::vector<int> number(tasks.size(), -1);
  std::vector<int> original;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (!chosen[i]) continue;
    number[i] = static_cast<int>(original.size());
    original.push_back(static_cast<int>(i));
  }
  if (original.empty()) return result;
  schedule::Network network;
  network.calendars = calendars_of(plan, draws);
  for (const interpreter::RobotSpec& robot : plan.robots) {
    network.resources.push_back({robot.name, calendar_index(plan, robot.calendar)});
  }
  for (const interpreter::CrewSpec& crew : plan.crews) {
    network.resources.push_back(
        {crew.name, calendar_index(plan, crew.calendar), static_cast<int>(crew.size)});
  }
  for (const int task : original) {
    schedule::NetworkTask& copy = network.tasks.emplace_back(tasks[at(task)]);
    for (schedule::Link& link : copy.after) link.task = number[at(link.task)];
  }
  auto times = schedule::times_of(network);
  auto* const found = std::get_if<schedule::NetworkTimes>(&times);
  if (!found) return result;  // the simulation shows where it stands still
  for (std::size_t i = 0; i < original.size(); ++i) {
    schedule::TaskTimes& task = found->tasks[i];
    if (task.task_before >= 0) task.task_before = original[at(task.task_before)];
    result[at(original[i])] = task;
  }
  return result;
}

}  // namespace rubicon::taskplan
