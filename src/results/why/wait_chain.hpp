#pragma once

#include <string>
#include <vector>

#include "src/results/why/task_story.hpp"

namespace rubicon::why {

/// Why a task began when it did: what it waited for last, what that waited for, and so on back to
/// the beginning of the plan; first to last. Begins with the last run of the task.
std::vector<WaitStep> wait_chain(const std::string& task, const RunsByTask& runs);

}  // namespace rubicon::why
