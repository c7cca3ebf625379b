#pragma once

#include <cstddef>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::advice {

/// `first` waited, before its start or on its way, for a robot or crew that `second` had.
struct QueueOrder {
  int first = -1;
  int second = -1;
};

/// Whom the task waited for so, the one who gave it back last first; then the same of each of these
/// and of the tasks whose links let it start or finish, and so on back. At most `most`. Tasks are
/// indices of the plan; those that are not done wait for nobody.
std::vector<QueueOrder> queue_orders(const interpreter::PlanModel& plan,
                                     const taskplan::Schedule& schedule, int task,
                                     std::size_t most);

}  // namespace rubicon::advice
