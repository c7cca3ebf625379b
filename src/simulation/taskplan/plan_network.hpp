#pragma once

#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/schedule/network.hpp"

namespace rubicon::taskplan {

/// The tasks of a plan with their links, priorities and crew work, as in the file; the work of a
/// task with motions is only its crews' share.
std::vector<schedule::NetworkTask> network_tasks(const interpreter::PlanModel& plan,
                                                 const interpreter::Draws& draws);

}  // namespace rubicon::taskplan
