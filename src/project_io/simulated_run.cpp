#include "src/project_io/simulated_run.hpp"

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
  task.duration.seconds = simulated.elapsed_seconds;
  task.format = kElapsed;
  task.constraint = Constraint::start_no_earlier_than;
  task.constraint_date = simulated.start;
  task.milestone = task.milestone && simulated.elapsed_seconds == 0;
}

}  // namespace

void take_run(const SimulatedRun& run, const std::vector<std::string>& names, Project& project) {
  project.start = run.start;
  project.finish = run.finish;
  std::unordered_map<std::int64_t, const SimulatedTask*> by_uid;
  for (std::size_t i = 0; i < project.tasks.size(); ++i) {
    const auto found = run.tasks.find(names[i]);
    if (names[i].empty() || found == run.tasks.end()) continue;
    take_task(found->second, project.tasks[i]);
    if (found->second.done) by_uid[project.tasks[i].uid] = &found->second;
  }
  for (Assignment& assignment : project.assignments) {
    const auto found = by_uid.find(assignment.task);
    if (found == by_uid.end()) continue;
    assignment.start = found->second->start;
    assignment.finish = found->second->finish;
  }
}

}  // namespace rubicon::project_io
