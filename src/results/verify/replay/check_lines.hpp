#pragma once

#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// Straight ways and locks of a run that happened: over steps of `line` in a row the tool is as
/// near to the straight way from the first to the last, and as evenly turned, as the deviation
/// allows; no step changes a locked parameter.
void check_lines(const Trace& trace, const TaskRun& run, Faults& faults);

}  // namespace rubicon::verify
