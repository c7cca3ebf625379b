#include "src/cli/result_project.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "interpreter/check/plan_model.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/project_io/project_of.hpp"
#include "src/exchange/project_io/write_mspdi.hpp"
#include "src/results/report/diagnostic_printer.hpp"
#include "src/results/report/header_files.hpp"
#include "src/results/report/schedule_text.hpp"
#include "src/simulation/schedule/civil_time.hpp"

namespace rubicon::cli {

namespace {

using report::clock_text;
using taskplan::TaskOutcome;
using taskplan::TaskResult;

std::string note_of(const taskplan::Schedule& schedule, const TaskOutcome& task) {
  if (task.result != TaskResult::done) {
    return fmt::format("rubicon: {}: {}", name_of(task.result), task.reason);
  }
  std::string note = fmt::format("rubicon: motion {}, crew work {}", clock_text(task.motion_time),
                                 clock_text(task.work_time));
  if (task.waits.machine > 0) note += ", waited for machines " + clock_text(task.waits.machine);
  if (schedule.costed) note += fmt::format(", cost {:.2f} {}", task.cost, schedule.currency);
  return note;
}

project_io::SimulatedRun run_of(const taskplan::Schedule& schedule) {
  const schedule::CivilTime start = schedule.start_at.value_or(schedule::kUndatedStart);
  const auto moment = [&](interpreter::Ticks time) {
    return project_io::Moment{report::moment_text(start, time)};
  };
  const auto seconds = [](interpreter::Ticks time) { return time / 1'000'000'000; };
  project_io::SimulatedRun run;
  run.start = moment(0);
  run.finish = moment(schedule.process_time);
  for (const TaskOutcome& task : schedule.tasks) {
    if (task.parking) continue;
    project_io::SimulatedTask& simulated = run.tasks[task.task];
    simulated.done = task.result == TaskResult::done;
    simulated.start = moment(task.start);
    simulated.finish = moment(task.start + task.duration);
    simulated.start_seconds = seconds(task.start);
    simulated.finish_seconds = seconds(task.start + task.duration);
    simulated.note = note_of(schedule, task);
  }
  return run;
}

}  // namespace

std::string result_mspdi(const ResultFiles& result, const taskplan::Schedule& schedule) {
  std::optional<report::HeaderFiles> files;
  try {
    files.emplace(result.trace_header());
  } catch (const std::invalid_argument& error) {
    throw WrongInput(fmt::format("{}:1: {}", result.trace_path(), error.what()));
  }
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  std::string text;
  std::unique_ptr<interpreter::PlanModel> plan;
  {
    interpreter::Diagnostics checked;
    plan = load_plan(files->plan_path(), sources, *files, checked, files->set());
    // What is only doubtful was said when the plan was run; of shapes, for which there are
    // stand-ins here, it would be wrong.
    if (!plan) diagnostics = std::move(checked);
  }
  if (plan) {
    const project_io::SimulatedRun run = run_of(schedule);
    text = project_io::write_mspdi(project_io::project_of(*plan, sources, diagnostics, &run));
  }
  const std::string messages =
      report::print_text(diagnostics.sorted(), sources, files::wants_colour(stderr));
  std::fwrite(messages.data(), 1, messages.size(), stderr);
  if (!plan) {
    throw WrongInput(
        fmt::format("{}:1: the plan that the trace carries cannot be read", result.trace_path()));
  }
  if (!schedule.start_at) {
    fmt::print(stderr, "rubicon: warning: the plan has no start_at; its schedule begins at {}\n",
               schedule::text_of(schedule::kUndatedStart));
  }
  return text;
}

}  // namespace rubicon::cli
