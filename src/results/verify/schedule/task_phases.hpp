#pragma once

#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// Checks that a task that is done did what the plan says, in its order: its motions, each to its
/// end; its works, by their crews and as long as planned; take, put down and remove.
void check_phases(const Trace& trace, const TaskRun& run, Faults& faults);

}  // namespace rubicon::verify
