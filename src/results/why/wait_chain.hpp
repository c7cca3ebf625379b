#pragma once

#include <map>
#include <string>
#include <vector>

#include "src/results/why/task_story.hpp"

namespace rubicon::why {

/// Why a task began when it did: what it waited for last, what that waited for, and so on back to
/// the beginning of the plan; first to last.
std::vector<WaitStep> wait_chain(const std::string& task,
                                 const std::map<std::string, TaskRun>& runs);

}  // namespace rubicon::why
