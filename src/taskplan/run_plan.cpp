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

/// A task that could not begin: what it waits for is not done.
TaskOutcome not_reached(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task,
                        const interpreter::TaskSpec& missing,
                        std::optional<TaskResult> missing_result, Ticks time) {
  TaskOutcome outcome;
  outcome.task = task.name;
  if (task.robot >= 0) outcome.robot = plan.robots[static_cast<std::size_t>(task.robot)].name;
  outcome.crews = crew_names(plan, task);
  outcome.start = time;
  outcome.result = TaskResult::not_reached;
  outcome.reason = fmt::format("it comes after {}, which is {}", missing.name,
                               name_of(missing_result.value_or(TaskResult::not_reached)));
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
    for (const int index : task_order(plan.tasks)) {
      const interpreter::TaskSpec& task = plan.tasks[static_cast<std::size_t>(index)];
      const std::optional<int> missing = missing_predecessor(task, results);
      TaskOutcome outcome;
      if (missing) {
        const auto m = static_cast<std::size_t>(*missing);
        outcome = not_reached(plan, task, plan.tasks[m], results[m], clock);
        if (trace) {
          trace->set_task(task.name, task.robot);
          trace->task_end(clock, name_of(outcome.result), outcome.reason);
        }
      } else {
        outcome = runner.run(task, clock);
      }
      results[static_cast<std::size_t>(index)] = outcome.result;
      add(std::move(outcome));
    }
  }
  schedule.process_time = clock;
  return schedule;
}

}  // namespace rubicon::taskplan
