#pragma once

#include <memory>
#include <optional>

#include "src/motion/robot/goal_problem.hpp"

namespace rubicon::robot {

/// The goal configuration by formula, for robots whose frames between mounting and tool are,
/// constant frames aside,
///   trans(x, y, z) * rotz(theta)                       a vehicle (any of the four may be constant)
///   rotz(theta) * trans(x, 0, z) [* rotz(theta')]      a crane, with or without a turning hook;
///                                                      x may be y, z constant.
///   ... * rotz(theta) * roty(phi) * roty(phi') * roty(phi'')
///                                                      an excavator's arm on whatever; any axes,
///                                                      if the last three are parallel, and not to
///                                                      the first
/// In the place of a parameter that slides may stand slope * z + offset, of one that turns theta +
/// offset; in an arm offset - theta, too. Of two solutions the better one (see
/// GoalProblem::better), of equals that in which the arm bends by a positive turn. Nothing if the
/// frames are of another form, or if no solution inside the ranges meets the position; of an arm,
/// the frame, with what is below it as it is. Vehicles and cranes: only if nothing is locked.
std::optional<GoalState> closed_form_goal(const GoalProblem& problem);

struct JointChain;

/// The formula of an arm that moves alone, for goals one after the other: its four parameters are
/// all that the problem may move.
class ArmFormula {
 public:
  /// Nothing if the robot is no such arm, or if anything else moves.
  static std::optional<ArmFormula> of(const GoalProblem& problem);

  /// The better solution of a problem with the same robot, where it stands, and the same values of
  /// all parameters that are not of the arm; nothing if the arm does not get there.
  std::optional<GoalState> solve(const GoalProblem& problem) const;

 private:
  explicit ArmFormula(JointChain chain);

  std::shared_ptr<const JointChain> chain_;  // shared: never changed
};

/// The goal configuration by search, for robots of any form.
GoalState search_goal(const GoalProblem& problem);

}  // namespace rubicon::robot
