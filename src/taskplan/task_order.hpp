#pragma once

#include <vector>

#include "interpreter/plan_model.hpp"

namespace rubicon::taskplan {

/// The tasks one after the other so that each comes after those it follows; where the plan leaves
/// it open, as they stand in the file. Tasks on a cycle of links (which checks refuse) come last.
std::vector<int> task_order(const std::vector<interpreter::TaskSpec>& tasks);

}  // namespace rubicon::taskplan
