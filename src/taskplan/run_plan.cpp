#include "src/taskplan/run_plan.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "src/site/make_site.hpp"
#include "src/taskplan/task_order.hpp"
#include "src/taskplan/task_runner.hpp"
#include "src/trace/trace_writer.hpp"

namespace rubicon::taskplan {

namespace {

/// The task of a task's links that keeps it from being done, if any.
std::optional<int> missing_predecessor(const interpreter::TaskSpec& task,
                                       const std::vector<std::optional<TaskResult>>& results) {
  for (const interpreter::LinkSpec& link : task.after) {
    if (results[static_cast<std::size_t>(link.task)] != TaskResult::done) return link.task;
  }
  return std::nullopt;
}

/// A task that could not begin: what it waits for is not done. `cause` is the rejected task behind
/// that, where there is one (tasks that wait for each other in a ring have none).
TaskOutcome not_reached(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task,
                        int missing, std::optional<int> cause, Ticks time) {
  TaskOutcome outcome;
  outcome.task = task.name;
  if (task.robot >= 0) outcome.robot = plan.robots[static_cast<std::size_t>(task.robot)].name;
  outcome.crews = crew_names(plan, task);
  outcome.start = time;
  outcome.result = TaskResult::not_reached;
  const auto name = [&](int index) { return plan.tasks[static_cast<std::size_t>(index)].name; };
  outcome.reason = fmt::format("it comes after {}, which is ", name(missing));
  if (cause == missing) {
    outcome.reason += name_of(TaskResult::rejected);
  } else {
    outcome.reason += name_of(TaskResult::not_reached);
    if (cause) {
      outcome.reason +=
          fmt::format(" because {} is {}", name(*cause), name_of(TaskResult::rejected));
    }
  }
  return outcome;
}

}  // namespace

Schedule run_plan(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                  trace::TraceSink* sink, const RunOptions& options) {
  std::optional<trace::TraceWriter> writer;
  if (sink) {
    writer.emplace(*sink, plan, sources, options.detail);
    writer->header();
  }
  trace::TraceWriter* trace = writer ? &*writer : nullptr;
  site::SiteWorld site = site::make_site(plan);
  TaskRunner runner(plan, sources, site, trace);
  Schedule schedule;
  Ticks clock = 0;
  const int total = plan.short_form ? 1 : static_cast<int>(plan.tasks.size());
  const auto add = [&](TaskOutcome outcome) {
    clock = outcome.start + outcome.duration;
    schedule.feasible = schedule.feasible && outcome.result == TaskResult::done;
    schedule.tasks.push_back(std::move(outcome));
    if (options.on_task) {
      options.on_task(static_cast<int>(schedule.tasks.size()), total, schedule.tasks.back());
    }
  };
  if (plan.short_form) {
    add(runner.run_short(clock));
  } else {
    std::vector<std::optional<TaskResult>> results(plan.tasks.size());
    std::vector<std::optional<int>> causes(plan.tasks.size());  // the rejected task behind a result
    for (const int index : task_order(plan.tasks)) {
      const interpreter::TaskSpec& task = plan.tasks[static_cast<std::size_t>(index)];
      const std::optional<int> missing = missing_predecessor(task, results);
      TaskOutcome outcome;
      if (missing) {
        const std::optional<int> cause = causes[static_cast<std::size_t>(*missing)];
        causes[static_cast<std::size_t>(index)] = cause;
        outcome = not_reached(plan, task, *missing, cause, clock);
        if (trace) {
          trace->set_task(task.name, task.robot);
          trace->task_end(clock, name_of(outcome.result), outcome.reason);
        }
      } else {
        outcome = runner.run(task, clock);
        if (outcome.result != TaskResult::done) causes[static_cast<std::size_t>(index)] = index;
      }
      results[static_cast<std::size_t>(index)] = outcome.result;
      add(std::move(outcome));
    }
  }
  schedule.process_time = clock;
  return schedule;
}

}  // namespace rubicon::taskplan
