#pragma once

#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// The waypoints of the motions of a run that happened: each begins once and in order, and what
/// ended otherwise than the task needs is tried again from one of its waypoints. The residuals of
/// its ends: by the values of the goal, or as far from the tool as the goal frame is said to be.
void check_goals(const Trace& trace, const TaskRun& run, Faults& faults);

}  // namespace rubicon::verify
