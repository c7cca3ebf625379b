#include "src/motion/math/pose.hpp"

#include <gtest/gtest.h>

#include <random>

#include "src/motion/math/angles.hpp"

namespace rubicon::math {
namespace {

TEST(Pose, QuarterTurnsAreExactAndRightHanded) {
  EXPECT_EQ(rotation_z_deg(90) * Vec3::UnitX(), Vec3::UnitY());
  EXPECT_EQ(rotation_x_deg(90) * Vec3::UnitY(), Vec3::UnitZ());
  EXPECT_EQ(rotation_y_deg(90) * Vec3::UnitZ(), Vec3::UnitX());
  EXPECT_EQ(translation(1, 2, 3) * Vec3(10, 20, 30), Vec3(11, 22, 33));
}

TEST(Pose, RotationAboutAnAxisAgreesWithTheElementaryRotations) {
  for (const double degrees : {-200.0, -33.0, 0.0, 1e-7, 45.0, 90.0, 179.0}) {
    EXPECT_EQ(rotation_about_deg(Vec3::UnitX(), degrees), rotation_x_deg(degrees).linear());
    EXPECT_EQ(rotation_about_deg(Vec3::UnitY(), degrees), rotation_y_deg(degrees).linear());
    EXPECT_EQ(rotation_about_deg(-Vec3::UnitZ(), degrees), rotation_z_deg(-degrees).linear());
  }
}

TEST(Pose, RotationAboutAnyAxisIsARotationAboutIt) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 axis = Vec3(number(random), number(random), number(random)).normalized();
    const double degrees = 180 * number(random);
    const Mat3 R = rotation_about_deg(axis, degrees);
    EXPECT_NEAR((R * R.transpose() - Mat3::Identity()).norm(), 0, 1e-14);
    EXPECT_NEAR((R * axis - axis).norm(), 0, 1e-14);
    EXPECT_NEAR(rotation_angle_deg(R), degrees < 0 ? -degrees : degrees, 1e-12);
    const Vec3 across = axis.unitOrthogonal();
    EXPECT_NEAR(axis.dot(across.cross(R * across)), sin_deg(degrees), 1e-14);
  }
}

TEST(Pose, SmallAnglesAreMeasuredAccurately) {
  for (const double degrees : {1e-3, 1e-7, 1e-12}) {
    EXPECT_NEAR(rotation_angle_deg(rotation_y_deg(degrees).linear()), degrees, degrees * 1e-12);
  }
  EXPECT_EQ(rotation_angle_deg(Mat3::Identity()), 0);
  EXPECT_EQ(rotation_angle_deg(rotation_z_deg(180).linear()), 180);
}

}  // namespace
}  // namespace rubicon::math
