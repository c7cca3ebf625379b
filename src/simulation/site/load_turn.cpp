#include "src/simulation/site/load_turn.hpp"

#include "src/motion/math/angles.hpp"

namespace rubicon::site {

namespace {

/// The angle by which a turn about the vertical comes nearest to the rotation, in (-180, 180].
double angle_about_vertical_deg(const math::Mat3& R) {
  return math::atan2_deg(R(1, 0) - R(0, 1), R(0, 0) + R(1, 1));
}

math::Mat3 about_vertical(double angle_deg) { return math::rotation_z_deg(angle_deg).linear(); }

}  // namespace

math::Pose turned(const math::Pose& X_WT, const math::Pose& X_TO, double angle_deg) {
  math::Pose X_TT = math::Pose::Identity();
  X_TT.linear() = X_WT.linear().transpose() * about_vertical(angle_deg) * X_WT.linear();
  return X_TT * X_TO;
}

geometry::Motion turn_motion(const math::Pose& X_WT, const math::Pose& X_TO, double angle_deg) {
  geometry::ScrewMotion turn;
  turn.X0 = X_WT * X_TO;
  turn.axis = math::Vec3::UnitZ();
  turn.point = X_WT.translation();
  turn.angle_deg = angle_deg;
  return geometry::Motion{turn};
}

FreeTurn free_turn(const robot::RobotModel& model, const robot::Mounting& mounting,
                   std::span<const double> q, const math::Pose& X_meant) {
  // A machine with a swivel keeps what hangs on it as it hangs; any other brings it as it comes.
  math::Pose X_guess = X_meant;
  const math::Mat3 R_now = robot::tool_pose(model, mounting, q).linear();
  const double nearest = angle_about_vertical_deg(R_now * X_meant.linear().transpose());
  X_guess.linear() = about_vertical(nearest) * X_meant.linear();
  const robot::GoalSolution found = robot::solve_goal(model, mounting, q, X_guess, {});
  const math::Mat3 R_WT = robot::tool_pose(model, mounting, found.q).linear();
  FreeTurn free{X_meant, angle_about_vertical_deg(X_meant.linear() * R_WT.transpose()), 0};
  free.X_WG.linear() = about_vertical(-free.angle_deg) * X_meant.linear();
  free.tilt_deg = math::rotation_angle_deg(R_WT.transpose() * free.X_WG.linear());
  return free;
}

}  // namespace rubicon::site
