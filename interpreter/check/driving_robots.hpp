#pragma once

#include <vector>

#include "interpreter/check/plan_model.hpp"

namespace rubicon::interpreter {

/// To each robot of a plan whether it drives on the ground, so that it must not come over a pit:
/// it hauls, or the body that has its tool frame is itself a vehicle, with parameters x and y and
/// none that lifts it.
std::vector<bool> driving_robots(const PlanModel& plan);

}  // namespace rubicon::interpreter
