#include "src/results/advice/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "src/simulation/taskplan/preflight_errors.hpp"
#include "src/simulation/taskplan/run_plan.hpp"

namespace rubicon::advice {

namespace {

using taskplan::Schedule;
using taskplan::TaskOutcome;
using taskplan::TaskResult;

RunSummary summary(const Schedule& schedule, const std::string& task) {
  RunSummary run;
  run.process_time = schedule.process_time;
  for (const TaskOutcome& each : schedule.tasks) {
    if (each.parking) continue;
    if (each.result == TaskResult::done) ++run.done;
    if (each.task != task) continue;
    run.result = name_of(each.result);
    run.reason = each.reason;
    if (each.result == TaskResult::done) run.end = each.start + each.duration;
  }
  return run;
}

std::map<std::string, bool> done_tasks(const Schedule& schedule) {
  std::map<std::string, bool> done;
  for (const TaskOutcome& each : schedule.tasks) {
    if (!each.parking) done[each.task] = each.result == TaskResult::done;
  }
  return done;
}

/// The rejected task that one which is not reached comes after, by links over others too; "": none.
std::string rejected_before(const interpreter::PlanModel& plan, const Schedule& schedule,
                            const std::string& task) {
  std::map<std::string, TaskResult> results;
  for (const TaskOutcome& each : schedule.tasks) results[each.task] = each.result;
  std::vector<bool> seen(plan.tasks.size(), false);
  std::vector<std::size_t> open;
  const auto add = [&](std::size_t index) {
    if (!seen[index]) open.push_back(index);
    seen[index] = true;
  };
  for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
    if (plan.tasks[i].name == task && results[task] == TaskResult::not_reached) add(i);
  }
  for (std::size_t next = 0; next < open.size(); ++next) {
    const interpreter::TaskSpec& each = plan.tasks[open[next]];
    const TaskResult result = results[each.name];
    if (result == TaskResult::rejected || result == TaskResult::ended_short) return each.name;
    if (result == TaskResult::done) continue;
    for (const auto& link : each.after) add(static_cast<std::size_t>(link.task));
  }
  return "";
}

bool helps(const RunSummary& before, const Trial& trial) {
  const bool done = trial.run.result == name_of(TaskResult::done);
  const bool was_done = before.result == name_of(TaskResult::done);
  const bool better = trial.run.end < before.end && trial.run.process_time <= before.process_time;
  return done && trial.lost.empty() && (!was_done || better);
}

}  // namespace

Advice advise(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
              const why::TaskStory& story) {
  const Schedule schedule = taskplan::run_plan(plan, sources, nullptr);
  const std::map<std::string, bool> done_before = done_tasks(schedule);
  Advice advice;
  advice.task = story.task;
  advice.tasks = static_cast<int>(done_before.size());
  advice.before = summary(schedule, story.task);
  advice.waits_for = rejected_before(plan, schedule, story.task);
  // No change of the task itself helps it then.
  if (!advice.waits_for.empty()) return advice;
  Changes changes = changes_for(plan, story, schedule);
  advice.left_out = std::move(changes.left_out);
  for (const Change& change : changes.changes) {
    if (advice.trials.size() >= kMostTrials) {
      advice.left_out.push_back({change.text, fmt::format("{} were tried before it", kMostTrials)});
      continue;
    }
    interpreter::PlanModel changed = plan;
    change.apply(changed);
    if (!taskplan::preflight_errors(changed).empty()) {
      advice.left_out.push_back({change.text, "such a plan cannot be run"});
      continue;
    }
    const Schedule after = taskplan::run_plan(changed, sources, nullptr);
    Trial trial{change.text, summary(after, story.task), {}, false};
    const std::map<std::string, bool> done_after = done_tasks(after);
    for (const auto& [task, done] : done_before) {
      if (done && !done_after.at(task)) trial.lost.push_back(task);
    }
    trial.helps = helps(advice.before, trial);
    advice.trials.push_back(std::move(trial));
  }
  return advice;
}

}  // namespace rubicon::advice
