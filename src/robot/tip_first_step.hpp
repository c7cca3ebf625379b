#pragma once

#include <vector>

#include "src/robot/goal_problem.hpp"

namespace rubicon::robot {

/// The step (m, rad, one entry for each of the first `count` variables) that, in the linear model
/// and inside the ranges, does in this order: meets the goal position; meets the goal orientation;
/// brings the base-most level as near as possible back to its value now; then the next level, and
/// so on to the tool's body. Each wish is fulfilled by least squares in what the wishes before it
/// leave free (task priority: Nakamura 1991; Siciliano and Slotine 1991), a variable that would
/// leave its range is held at its limit (Flacco, De Luca and Khatib 2012).
std::vector<double> tip_first_step(const GoalProblem& problem, const GoalState& state,
                                   std::size_t count);

}  // namespace rubicon::robot
