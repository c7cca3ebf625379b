#include "src/motion/math/pose.hpp"

#include <cmath>

#include "src/motion/math/angles.hpp"

namespace rubicon::math {
namespace {

Pose rotation(const Mat3& R) {
  Pose X = Pose::Identity();
  X.linear() = R;
  return X;
}

}  // namespace

Pose translation(double x, double y, double z) {
  Pose X = Pose::Identity();
  X.translation() = Vec3(x, y, z);
  return X;
}

Pose rotation_x_deg(double degrees) {
  const auto [s, c] = sine_cosine_deg(degrees);
  Mat3 R;
  R << 1, 0, 0, 0, c, -s, 0, s, c;
  return rotation(R);
}

Pose rotation_y_deg(double degrees) {
  const auto [s, c] = sine_cosine_deg(degrees);
  Mat3 R;
  R << c, 0, s, 0, 1, 0, -s, 0, c;
  return rotation(R);
}

Pose rotation_z_deg(double degrees) {
  const auto [s, c] = sine_cosine_deg(degrees);
  Mat3 R;
  R << c, -s, 0, s, c, 0, 0, 0, 1;
  return rotation(R);
}

Mat3 rotation_about_deg(const Vec3& axis, double degrees) {
  // The coordinate axes, by far the most common, without the rounding of the general formula.
  if (axis.y() == 0 && axis.z() == 0)
    return rotation_x_deg(axis.x() < 0 ? -degrees : degrees).linear();
  if (axis.x() == 0 && axis.z() == 0)
    return rotation_y_deg(axis.y() < 0 ? -degrees : degrees).linear();
  if (axis.x() == 0 && axis.y() == 0)
    return rotation_z_deg(axis.z() < 0 ? -degrees : degrees).linear();
  const auto [s, c] = sine_cosine_deg(degrees);
  const double x = axis.x();
  const double y = axis.y();
  const double z = axis.z();
  const double v = 1 - c;
  Mat3 R;
  R << x * x * v + c, x * y * v - z * s, x * z * v + y * s,  //
      x * y * v + z * s, y * y * v + c, y * z * v - x * s,   //
      x * z * v - y * s, y * z * v + x * s, z * z * v + c;
  return R;
}

double rotation_angle_deg(const Mat3& R) {
  const double x = R(2, 1) - R(1, 2);
  const double y = R(0, 2) - R(2, 0);
  const double z = R(1, 0) - R(0, 1);
  const double twice_sine = std::sqrt(x * x + y * y + z * z);
  const double twice_cosine = R(0, 0) + R(1, 1) + R(2, 2) - 1;
  return atan2_deg(twice_sine, twice_cosine);
}

}  // namespace rubicon::math
