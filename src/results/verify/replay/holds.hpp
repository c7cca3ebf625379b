#pragma once

#include <vector>

#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// A robot or crew is in a task.
struct Hold {
  int resource = -1;  ///< robots first, then crews
  Ticks from = 0;
  Ticks to = 0;
  int run = -1;  ///< index into the runs
  int line = 0;
  bool whole = true;  ///< from the start to the finish of the task; else for one work
  int people = 1;     ///< of a crew
};

/// What a task that happened had: its robot and crews from its start to its finish, and the crews
/// of single works while these last. A task without work has nobody.
std::vector<Hold> holds_of(const Trace& trace, const std::vector<TaskRun>& runs, int index);

/// The calendars of all whom a task had from its start to its finish.
std::vector<int> calendars_of(const Trace& trace, const std::vector<TaskRun>& runs, int index);

/// People of a crew; 1 of a robot.
int size_of_resource(const Scene& scene, int resource);
/// Its name.
const std::string& resource_name(const Scene& scene, int resource);
/// Its calendar: none, or one.
std::vector<int> calendar_of_resource(const Scene& scene, int resource);

}  // namespace rubicon::verify
