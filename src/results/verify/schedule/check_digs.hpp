#pragma once

#include <vector>

#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// Whether tasks that dig take as long, and tip as much, as their rounds do. Where each duration is
/// certain the rounds are gone through again, truck by truck; where some were drawn, the time and
/// the loads are held against what the least durations allow. The same of how long trucks drive and
/// are served, where the trace tells it.
void check_digs(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults);

}  // namespace rubicon::verify
