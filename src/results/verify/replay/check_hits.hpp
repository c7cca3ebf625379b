#pragma once

#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// Why attempts were refused: a reason that there is, with a hit where it is one; what moved
/// belongs to the robot, what it met is on the site; and the counts of each end by reason.
void check_hits(const Trace& trace, const TaskRun& run, Faults& faults);

}  // namespace rubicon::verify
