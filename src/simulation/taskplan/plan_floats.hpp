#pragma once

#include <functional>
#include <vector>

#include "src/simulation/schedule/link_state.hpp"
#include "src/simulation/schedule/task_float.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::taskplan {

/// A task of the plan that is done, and what its floats are counted by.
struct DoneTask {
  int task = -1;        ///< index into the plan
  std::size_t row = 0;  ///< its place in Schedule::tasks
  const schedule::WorkCalendar* calendar = nullptr;
  bool milestone = false;
  double priority = 0;
  std::vector<schedule::TaskPart> parts = {};
};

/// Gives each of `done` its floats, in `schedule`. By the links of the plan, by the order in which
/// robots and crews went from task to task, and by what tasks waited for on their way; where
/// machines met nobody they are free to come at other times, which nobody has tried. A machine that
/// broke down at the end of a task is repaired before it has the next one, in its hours.
void add_floats(const std::vector<DoneTask>& done, const schedule::LinkState& links,
                const std::function<const schedule::WorkCalendar&(int resource)>& hours_of,
                Schedule& schedule);

}  // namespace rubicon::taskplan
