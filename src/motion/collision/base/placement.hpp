#pragma once

#include <cmath>

#include "src/motion/math/pose.hpp"

namespace rubicon::collision {

using math::Mat3;
using math::Pose;
using math::Vec3;

/// A rigid transform as its two parts, p' = R p + t (m): what the inner loops need of a `Pose`.
struct Placement {
  Mat3 R = Mat3::Identity();
  Vec3 t = Vec3::Zero();

  Placement() = default;
  Placement(const Mat3& rotation, const Vec3& translation) : R(rotation), t(translation) {}
  explicit Placement(const Pose& X) : R(X.linear()), t(X.translation()) {}

  Vec3 operator*(const Vec3& p) const { return R * p + t; }
  Placement inverse() const {
    const Mat3 transposed = R.transpose();
    return {transposed, -(transposed * t)};
  }
};

/// How far each of the frame's axes is from a unit vector (sine of the angle): what of a growth
/// across it counts along them.
inline Vec3 across_axes(const Vec3& axis) {
  const Vec3 squares = axis.cwiseAbs2();
  return {std::sqrt(squares.y() + squares.z()), std::sqrt(squares.z() + squares.x()),
          std::sqrt(squares.x() + squares.y())};
}

/// `a` as `b` sees it; the difference of the positions first, so that far from the origin nothing
/// is lost.
inline Placement relative(const Placement& a, const Placement& b) {
  const Mat3 to_b = b.R.transpose();
  return {to_b * a.R, to_b * (a.t - b.t)};
}

}  // namespace rubicon::collision
