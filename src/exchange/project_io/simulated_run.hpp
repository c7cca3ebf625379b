#pragma once

#include <map>
#include <string>
#include <vector>

#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

/// How a task of a plan went when the plan was run.
struct SimulatedTask {
  bool done = false;
  Moment start, finish;            ///< if it is done; to the second
  std::int64_t start_seconds = 0;  ///< the same from the begin of the plan
  std::int64_t finish_seconds = 0;
  std::string note;  ///< for people: what it took, or why it was not done
};

/// How a plan went.
struct SimulatedRun {
  Moment start, finish;
  std::map<std::string, SimulatedTask> tasks;  ///< by the plan's name
};

/// A line of the schedule as the plan has it: the task `name`, or `name`_begins, `parts` and
/// `name`_ends. A heading has neither.
struct PlannedLine {
  std::string name;
  std::vector<std::string> parts;
};

/// Puts a run into the schedule of its plan: tasks that were done stand, by hand, where they stood
/// in the run, for the time that they lasted, and may not start sooner; they and their assignments
/// get its dates. What was not done stays as it is planned. All get the note. `lines` are those of
/// the project's tasks.
void take_run(const SimulatedRun& run, const std::vector<PlannedLine>& lines, Project& project);

}  // namespace rubicon::project_io
