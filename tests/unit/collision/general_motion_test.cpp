#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/collision/box_oracle.hpp"
#include "tests/unit/collision/random_scene.hpp"
#include "tests/unit/collision/two_joint_motion.hpp"

namespace rubicon::collision::test {
namespace {

TwoJointMotion random_crane(Random& random, double radius) {
  TwoJointMotion crane;
  crane.theta0 = random.between(-180, 180);
  crane.theta1 = crane.theta0 + random.between(-10, 10);
  crane.place0 =
      Vec3(random.between(1, radius), random.between(-0.5, 0.5), random.between(-0.5, 0.5));
  crane.place1 = crane.place0 + random.vector(0.5);
  return crane;
}

TEST(GeneralMotion, AgreesWithBranchAndBound) {
  Random random(51);
  int free = 0;
  int hit = 0;
  for (int i = 0; i < 2000; ++i) {
    const TwoJointMotion crane = random_crane(random, i % 2 ? 3 : 30);
    const Vec3 half(random.between(0.05, 1), random.between(0.05, 1), random.between(0.05, 1));
    OracleBox wall{crane.pose(random.between(-0.2, 1.2)),
                   Vec3(random.between(0.1, 2), random.between(0.01, 0.1), random.between(0.1, 2))};
    wall.X_WC.linear() = random.rotation();
    wall.X_WC.translation() += random.vector(1);
    const double tolerance = i % 3 ? 1e-3 : 1e-6;
    const Truth truth = classify(
        [&](double s) {
          return box_depth({crane.pose(s), half}, wall);
        },
        speed_of(crane, half.norm()), tolerance, kBand);
    if (truth == Truth::kNearBoundary) continue;
    ++(truth == Truth::kHit ? hit : free);
    EXPECT_EQ(blocked(*box(half), crane.motion(), box(wall.half), wall.X_WC, tolerance),
              truth == Truth::kHit)
        << "case " << i;
  }
  EXPECT_GT(free, 300);
  EXPECT_GT(hit, 300);
}

TEST(GeneralMotion, SlidingOnASlabWithTwoJointsIsFree) {
  const BodyPtr load = box(Vec3(0.5, 0.3, 0.2));
  const BodyPtr slab = box(Vec3(40, 40, 0.1));
  TwoJointMotion crane;
  crane.theta1 = 5;
  crane.place0 = Vec3(10, 0, 0.3);
  crane.place1 = Vec3(10.5, 0, 0.3);
  EXPECT_FALSE(blocked(*load, crane.motion(), slab, at(0, 0, 0), 1e-3));
  EXPECT_FALSE(blocked(*load, crane.motion(), slab, at(0, 0, 0), 1e-6));
  EXPECT_TRUE(blocked(*load, crane.motion(), slab, at(0, 0, 1e-3), 1e-6));
}

/// A motion that promises nothing.
class Boundless : public geometry::GeneralMotion {
 public:
  explicit Boundless(double bound) : bound_(bound) {}
  Pose pose(double s) const override { return math::translation(s, 0, 0); }
  double chord_deviation(double, double, double) const override { return bound_; }

 private:
  double bound_;
};

TEST(GeneralMotion, WithoutABoundItIsAHitAndEnds) {
  const BodyPtr cube = box(Vec3::Constant(0.1));
  for (const double bound :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 100.0}) {
    EXPECT_TRUE(
        blocked(*cube, Motion{std::make_shared<Boundless>(bound)}, cube, at(0.5, 5, 0), 1e-3))
        << bound;
  }
}

}  // namespace
}  // namespace rubicon::collision::test
