#pragma once

#include <map>
#include <optional>
#include <string>

#include "src/project_io/project.hpp"

namespace rubicon::project_io {

/// How a task of a plan went when the plan was run.
struct SimulatedTask {
  bool done = false;
  Moment start, finish;              ///< if it is done; to the second
  std::int64_t elapsed_seconds = 0;  ///< from start to finish, nights included
  std::string note;                  ///< for people: what it took, or why it was not done
};

/// How a plan went.
struct SimulatedRun {
  Moment start, finish;
  std::map<std::string, SimulatedTask> tasks;  ///< by the plan's name
};

/// Puts a run into the schedule of its plan: tasks that were done stand, by hand, where they stood
/// in the run, for the time that they lasted, and may not start sooner; they and their assignments
/// get its dates. What was not done stays as it is planned. All get the note. `names` are those in
/// the plan of the project's tasks, "" for lines that the plan has no task for.
void take_run(const SimulatedRun& run, const std::vector<std::string>& names, Project& project);

}  // namespace rubicon::project_io
