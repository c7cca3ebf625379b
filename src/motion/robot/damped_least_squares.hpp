#pragma once

#include "src/motion/robot/goal_problem.hpp"

namespace rubicon::robot {

/// What of the goal frame counts.
enum class GoalPart { position, pose };

/// Nearest configuration to the goal that Levenberg's damped least squares finds from `start` by
/// moving the first `count` variables inside their ranges (1 rad weighs as much as 1 m). A variable
/// that would leave its range is held at its limit and the others are solved again (active set). A
/// local minimum; bounded iterations.
GoalState damped_least_squares(const GoalProblem& problem, GoalState start, std::size_t count,
                               GoalPart part);

}  // namespace rubicon::robot
