#pragma once

#include <optional>

#include "src/motion/robot/goal_problem.hpp"

namespace rubicon::robot {

/// The goal configuration by formula, for robots whose frames between mounting and tool are,
/// constant frames aside,
///   trans(x, y, z) * rotz(theta)                       a vehicle (any of the four may be constant)
///   rotz(theta) * trans(x, 0, z) [* rotz(theta')]      a crane, with or without a turning hook;
///                                                      x may be y, z constant.
/// In the place of a parameter that slides may stand slope * z + offset, of one that turns theta +
/// offset. Of a crane's two solutions the better one (see GoalProblem::better). Nothing if the
/// frames are of another form, or if no solution inside the ranges meets the position.
std::optional<GoalState> closed_form_goal(const GoalProblem& problem);

}  // namespace rubicon::robot
