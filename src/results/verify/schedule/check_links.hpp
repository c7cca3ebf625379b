#pragma once

#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// Checks the links of all tasks that are done: that none was begun or ended before what it follows
/// lets it, or without it; and that what was not reached follows something that is not done.
void check_links(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults);

}  // namespace rubicon::verify
