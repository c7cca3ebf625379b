#pragma once

#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// The guides of a run that happened: their waypoints begin in order, and each step of `follow`
/// brings all that it moves nearer to the waypoint in one proportion.
void check_guides(const Trace& trace, const TaskRun& run, Faults& faults);

}  // namespace rubicon::verify
