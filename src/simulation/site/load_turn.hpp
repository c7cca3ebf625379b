#pragma once

#include <span>

#include "src/motion/geometry/motion.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::site {

/// How a load hangs (X_TO) that hung at X_TO and was turned by an angle about the vertical through
/// the origin of the tool, which stands at X_WT.
math::Pose turned(const math::Pose& X_WT, const math::Pose& X_TO, double angle_deg);

/// The motion of the load while it is turned. World frame.
geometry::Motion turn_motion(const math::Pose& X_WT, const math::Pose& X_TO, double angle_deg);

/// A frame that a tool goes to with something that may be turned about the vertical beneath it.
struct FreeTurn {
  math::Pose X_WG = math::Pose::Identity();  ///< the frame as the machine is to reach it
  double angle_deg = 0;  ///< from that to the frame that is meant, in (-180, 180]
  double tilt_deg = 0;   ///< by how much the machine comes otherwise turned than upright to it
};

/// The frame that is meant, turned about the vertical through its origin so that the machine
/// reaches it as it comes there: X_meant is X_WG turned by `angle_deg`.
FreeTurn free_turn(const robot::RobotModel& model, const robot::Mounting& mounting,
                   std::span<const double> q, const math::Pose& X_meant);

}  // namespace rubicon::site
