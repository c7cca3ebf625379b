#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <variant>

#include "src/motion/geometry/motion.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::collision::test {

/// A crane that slews about z while its trolley runs along the jib: X(s) = Rz(theta) * T(x, y, z) *
/// Rz(spin).
class TwoJointMotion : public geometry::GeneralMotion {
 public:
  double theta0 = 0;  ///< deg
  double theta1 = 0;
  math::Vec3 place0 = math::Vec3::Zero();  ///< m, in the frame of the jib
  math::Vec3 place1 = math::Vec3::Zero();

  math::Pose pose(double s) const override {
    const math::Vec3 place = place0 + s * (place1 - place0);
    return math::rotation_z_deg(theta0 + s * (theta1 - theta0)) *
           math::translation(place.x(), place.y(), place.z());
  }

  /// From the second derivative: |x''| <= w^2 r + 2 w v.
  double chord_deviation(double s0, double s1, double reach) const override {
    const double w = math::radians(theta1 - theta0 < 0 ? theta0 - theta1 : theta1 - theta0);
    const double radius = std::max(place0.norm(), place1.norm()) + reach;
    const double v = (place1 - place0).norm();
    return (w * w * radius + 2 * w * v) * (s1 - s0) * (s1 - s0) / 8;
  }

  geometry::Motion motion() const { return {std::make_shared<TwoJointMotion>(*this)}; }
};

/// Upper bound of the way (m per unit of s) of any point within `reach` of the moved origin.
inline double speed_of(const TwoJointMotion& crane, double reach) {
  return math::radians(std::fabs(crane.theta1 - crane.theta0)) *
             (std::max(crane.place0.norm(), crane.place1.norm()) + reach) +
         (crane.place1 - crane.place0).norm();
}

/// The same for a screw or a crane.
inline double speed_of(const geometry::Motion& motion, double reach) {
  if (const auto* screw = std::get_if<geometry::ScrewMotion>(&motion.kind)) {
    const double radius = screw->axis.cross(screw->X0.translation() - screw->point).norm() + reach;
    return math::radians(std::fabs(screw->angle_deg)) * radius + screw->slide.norm();
  }
  return speed_of(dynamic_cast<const TwoJointMotion&>(*std::get<1>(motion.kind)), reach);
}

}  // namespace rubicon::collision::test
