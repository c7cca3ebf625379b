#pragma once

#include <span>
#include <vector>

#include "src/motion/geometry/motion.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::robot {

/// The motions of all bodies (in model order), and last of the tool frame, while q runs linearly
/// from q0 to q1 (cyclic angles unwrapped): an exact translation or screw about a fixed axis where
/// the frames give one, else a general motion with rigorous bounds from interval arithmetic. A body
/// that does not move has a motion with `moves() == false`. The result refers to nothing: it may
/// outlive the arguments but for the model and mounting.
std::vector<geometry::Motion> step_motions(const RobotModel& model, const Mounting& mounting,
                                           std::span<const double> q0, std::span<const double> q1);

}  // namespace rubicon::robot
