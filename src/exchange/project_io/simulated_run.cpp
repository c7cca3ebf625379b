#include "src/exchange/project_io/simulated_run.hpp"

#include <optional>
#include <unordered_map>

namespace rubicon::project_io {

namespace {

/// Elapsed, so that the finish is that of the run whatever calendar a program counts with.
constexpr TimeFormat kElapsed{TimeUnit::hours, true, false};

void take_task(const SimulatedTask& simulated, Task& task) {
  if (!task.notes.empty()) task.notes += "\n";
  task.notes += simulated.note;
  if (!simulated.done) return;
  task.manual = true;
  task.start = simulated.start;
  task.finish = simulated.finish;
  if (!task.actual_start.text.empty()) task.actual_start = simulated.start;
  if (!task.actual_finish.text.empty()) task.actual_finish = simulated.finish;
  task.duration.seconds = simulated.finish_seconds - simulated.start_seconds;
  task.format = kElapsed;
  task.constraint = Constraint::start_no_earlier_than;
  task.constraint_date = simulated.start;
  task.milestone = task.milestone && task.duration.seconds == 0;
}

/// A line that is done in parts: from its begin to the last of its parts, of which some may have
/// been left out.
SimulatedTask in_parts(const SimulatedRun& run, const PlannedLine& planned,
                       const SimulatedTask& begin, const SimulatedTask& end) {
  SimulatedTask line = end;
  line.done = begin.done && end.done;
  line.start = begin.start;
  line.start_seconds = begin.start_seconds;
  std::size_t done = 0;
  for (const std::string& name : planned.parts) {
    const auto part = run.tasks.find(name);
    if (part == run.tasks.end() || !part->second.done) continue;
    ++done;
    if (part->second.finish_seconds <= line.finish_seconds) continue;
    line.finish_seconds = part->second.finish_seconds;
    line.finish = part->second.finish;
  }
  const std::string parts =
      std::to_string(done) + " of " + std::to_string(planned.parts.size()) + " parts done";
  line.note = line.done ? "rubicon: " + parts : line.note + "; " + parts;
  return line;
}

/// How a line of the schedule went; nothing for one that the plan has no task for.
std::optional<SimulatedTask> line_of(const SimulatedRun& run, const PlannedLine& planned) {
  const auto whole = run.tasks.find(planned.name);
  if (whole != run.tasks.end()) return whole->second;
  const auto begin = run.tasks.find(planned.name + "_begins");
  const auto end = run.tasks.find(planned.name + "_ends");
  if (begin == run.tasks.end() || end == run.tasks.end()) return std::nullopt;
  return in_parts(run, planned, begin->second, end->second);
}

}  // namespace

void take_run(const SimulatedRun& run, const std::vector<PlannedLine>& lines, Project& project) {
  project.start = run.start;
  project.finish = run.finish;
  std::unordered_map<std::int64_t, SimulatedTask> by_uid;
  for (std::size_t i = 0; i < project.tasks.size(); ++i) {
    if (project.is_heading(i)) continue;  // it goes by what is below it
    const std::optional<SimulatedTask> line = line_of(run, lines[i]);
    if (!line) continue;
    take_task(*line, project.tasks[i]);
    if (line->done) by_uid.emplace(project.tasks[i].uid, *line);
  }
  for (Assignment& assignment : project.assignments) {
    const auto found = by_uid.find(assignment.task);
    if (found == by_uid.end()) continue;
    assignment.start = found->second.start;
    assignment.finish = found->second.finish;
  }
}

}  // namespace rubicon::project_io
