#pragma once

#include "src/results/verify/replay/task_run.hpp"
#include "src/results/verify/schedule/working_hours.hpp"

namespace rubicon::verify {

/// Checks that crew work takes its time in the hours in which all that its task holds and its own
/// crew work, and no longer; that no motion begins out of shift; and that with `carry_over` no step
/// does.
void check_shifts(const Trace& trace, const TaskRun& run, const WorkingHours& hours,
                  Faults& faults);

}  // namespace rubicon::verify
