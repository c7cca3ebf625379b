#pragma once

#include <Eigen/Geometry>

namespace rubicon::math {

/// A point or vector in metres.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// A rigid transform X_AB: p_A = X_AB * p_B (rotation part `linear()`, translation part
/// `translation()`, metres).
using Pose = Eigen::Isometry3d;

/// The elementary transforms of the language; angles in degrees, right-handed, exact at multiples
/// of 90.
Pose translation(double x, double y, double z);
Pose rotation_x_deg(double degrees);
Pose rotation_y_deg(double degrees);
Pose rotation_z_deg(double degrees);

/// Rotation about the unit vector `axis` through the origin (Rodrigues), angle in degrees.
Mat3 rotation_about_deg(const Vec3& axis, double degrees);

/// Angle of the rotation R in degrees, [0, 180], accurate also near 0.
double rotation_angle_deg(const Mat3& R);

}  // namespace rubicon::math
