#include "src/motion/geometry/above.hpp"

#include <gtest/gtest.h>

#include "src/motion/math/angles.hpp"

namespace rubicon::geometry {

namespace {

Pose moved(double x, double y, double z) {
  Pose X = Pose::Identity();
  X.translation() = Vec3(x, y, z);
  return X;
}

Pose tilted(double degrees) {
  Pose X = Pose::Identity();
  const double c = math::cos_deg(degrees);
  const double s = math::sin_deg(degrees);
  X.linear() << c, 0, s, 0, 1, 0, -s, 0, c;
  return X;
}

TEST(Above, UprightShapesGrowToTheTop) {
  const Shape box = with_what_is_above({Box{{-1, -1, 0}, {1, 1, 2}}, moved(5, 0, 3)}, 30);
  EXPECT_EQ(std::get<Box>(box.solid).lower, Vec3(-1, -1, 0));
  EXPECT_EQ(std::get<Box>(box.solid).upper, Vec3(1, 1, 27));
  EXPECT_EQ(box.X_BS.translation(), Vec3(5, 0, 3));
  const Shape drum = with_what_is_above({Cylinder{2, 0, 1}, moved(0, 0, 4)}, 30);
  EXPECT_EQ(std::get<Cylinder>(drum.solid).z0, 0);
  EXPECT_EQ(std::get<Cylinder>(drum.solid).z1, 26);
  const Shape slab =
      with_what_is_above({Prism{0, 1, {{0, 0}, {1, 0}, {0, 1}}}, moved(0, 0, 4)}, 30);
  EXPECT_EQ(std::get<Prism>(slab.solid).z1, 26);
  const Shape ball = with_what_is_above({Sphere{{1, 2, 3}, 0.5}, moved(1, 0, 0)}, 30);
  EXPECT_EQ(std::get<Capsule>(ball.solid).a, Vec3(2, 2, 3));
  EXPECT_EQ(std::get<Capsule>(ball.solid).b, Vec3(2, 2, 30));
  EXPECT_EQ(std::get<Capsule>(ball.solid).radius, 0.5);
}

TEST(Above, OfWhatLeansTheBoxAround) {
  // A pipe along x: a cylinder turned by 90 degrees about y.
  Shape pipe{Cylinder{0.5, -3, 3}, tilted(90)};
  pipe.X_BS.translation() = Vec3(0, 10, 1);
  const Shape raised = with_what_is_above(pipe, 30);
  const auto& box = std::get<Box>(raised.solid);
  EXPECT_NEAR((box.lower - Vec3(-3, 9.5, 0.5)).norm(), 0, 1e-12);
  EXPECT_NEAR((box.upper - Vec3(3, 10.5, 30)).norm(), 0, 1e-12);
  EXPECT_NEAR(highest_point(pipe), 1.5, 1e-12);
}

TEST(Above, NothingIsAddedToWhatReachesTheTop) {
  const Shape box{Box{{-1, -1, 0}, {1, 1, 2}}, moved(0, 0, 3)};
  EXPECT_EQ(highest_point(box), 5);
  EXPECT_EQ(std::get<Box>(with_what_is_above(box, 5).solid).upper.z(), 2);
  EXPECT_EQ(std::get<Box>(with_what_is_above(box, -7).solid).upper.z(), 2);
}

}  // namespace

}  // namespace rubicon::geometry
