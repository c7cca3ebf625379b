#pragma once

#include <vector>

#include "src/motion/robot/goal_problem.hpp"

namespace rubicon::robot {

/// The step (m, rad, one entry for each of the first `count` variables) that, in the linear model
/// and inside the ranges, does in this order: meets the goal position; meets the goal orientation;
/// brings the base-most level as near as possible back to its value now; then the next level, and
/// so on to the tool's body. Each wish is fulfilled by least squares in what the wishes before it
/// leave free (task priority: Nakamura 1991; Siciliano and Slotine 1991); the ranges are kept by a
/// primal active set, so where the robot is linear and `state` meets the goal as well as it can be
/// met, the step is the lexicographic optimum.
std::vector<double> tip_first_step(const GoalProblem& problem, const GoalState& state,
                                   std::size_t count);

}  // namespace rubicon::robot
