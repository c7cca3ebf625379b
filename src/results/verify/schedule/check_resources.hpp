#pragma once

#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// Checks that no robot and no crew is in two tasks at once. A task holds its robot and the crews
/// of `by` while it lasts (without a robot those of its works too), and the crew of a work while
/// that lasts.
void check_resources(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults);

}  // namespace rubicon::verify
