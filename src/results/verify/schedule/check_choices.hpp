#pragma once

#include <optional>
#include <vector>

#include "src/results/verify/input/record.hpp"
#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// The trace with each task by pools as the trace says it was chosen; nothing if no task is by
/// pools. What is no choice of its pools is a fault.
std::optional<Trace> with_choices(const Trace& trace, Faults& faults);

/// Tasks with the same members as another have them, and nobody has these in between.
void check_same_as(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults);

/// What tasks with the same members had was kept until then for one of them that was not done.
struct Kept {
  int resource = -1;  ///< robots first, then crews
  Ticks until = 0;
};
std::vector<Kept> kept_for_nothing(const Trace& trace, const std::vector<TaskRun>& runs);

}  // namespace rubicon::verify
