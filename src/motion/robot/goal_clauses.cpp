#include "src/motion/robot/goal_clauses.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"

namespace rubicon::robot {
namespace {

/// Twice the sine of an angle below which a half turn's axis is read off the symmetric part of the
/// matrix.
constexpr double kHalfTurn = 1e-6;

int axis_of(FreeTurn free) { return static_cast<int>(free) - static_cast<int>(FreeTurn::x); }

}  // namespace

bool GoalClauses::locks(int parameter) const {
  return std::binary_search(locked.begin(), locked.end(), parameter);
}

math::Vec3 rotation_vector(const math::Mat3& R) {
  math::Vec3 twice_sine(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double length = twice_sine.norm();
  const double angle = math::radians(math::rotation_angle_deg(R));
  if (length > kHalfTurn || angle < 1) {
    return length > 0 ? math::Vec3(twice_sine * (angle / length)) : math::Vec3::Zero();
  }
  // Near a half turn R + I is twice the outer product of the axis.
  const math::Mat3 outer = R + math::Mat3::Identity();
  int largest = 0;
  for (int i = 1; i < 3; ++i) {
    if (outer(i, i) > outer(largest, largest)) largest = i;
  }
  const math::Vec3 axis = outer.col(largest).normalized();
  return (axis.dot(twice_sine) < 0 ? -angle : angle) * axis;
}

math::Mat3 rotation_by(const math::Vec3& vector) {
  const double angle = vector.norm();
  if (!(angle > 0)) return math::Mat3::Identity();
  return math::rotation_about_deg(vector / angle, math::degrees(angle));
}

math::Vec3 turn_to_goal(const math::Mat3& R_WT, const math::Mat3& R_WG, FreeTurn free) {
  if (free == FreeTurn::none) return rotation_vector(R_WG * R_WT.transpose());
  if (free == FreeTurn::all) return math::Vec3::Zero();
  const int k = axis_of(free);
  const math::Vec3 is = R_WT.col(k);
  const math::Vec3 should = R_WG.col(k);
  const math::Vec3 across = is.cross(should);
  const double sine = across.norm();
  const double angle = math::radians(math::atan2_deg(sine, is.dot(should)));
  if (sine > 0) return across * (angle / sine);
  // A half turn may be made about any axis across.
  return angle > 1 ? math::Vec3(angle * R_WT.col((k + 1) % 3)) : math::Vec3::Zero();
}

double turn_off_deg(const math::Mat3& R_WT, const math::Mat3& R_WG, FreeTurn free) {
  if (free == FreeTurn::none) return math::rotation_angle_deg(R_WT.transpose() * R_WG);
  return math::degrees(turn_to_goal(R_WT, R_WG, free).norm());
}

math::Vec3 turn_that_counts(const math::Vec3& turn, const math::Mat3& R_WT, FreeTurn free) {
  if (free == FreeTurn::none) return turn;
  if (free == FreeTurn::all) return math::Vec3::Zero();
  const math::Vec3 axis = R_WT.col(axis_of(free));
  return turn - axis * axis.dot(turn);
}

}  // namespace rubicon::robot
