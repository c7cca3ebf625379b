#include <gtest/gtest.h>

#include "tests/unit/collision/box_oracle.hpp"
#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {
namespace {

/// Answers nearer to the tolerance than this (m) are left to rounding.
constexpr double kRoundingBand = 1e-7;

/// One box moves along d past another; the exact depth of the swept volume decides.
void check(const OracleBox& a, const Vec3& d, const OracleBox& b, double tolerance, Count& count) {
  const double depth = swept_box_depth(a, d, b);
  if (std::fabs(depth - tolerance) < kRoundingBand) return;
  const bool expected = depth > tolerance;
  ++(expected ? count.hit : count.free);
  const bool found =
      blocked(*box(a.half), geometry::translating(a.X_WC, d), box(b.half), b.X_WC, tolerance);
  ASSERT_EQ(found, expected) << "swept depth " << depth << " m, tolerance " << tolerance << " m";
}

TEST(Translation, GenericBoxes) {
  Random random(1);
  Count count;
  for (int i = 0; i < 6000; ++i) {
    const OracleBox a{random.pose(0.8), Vec3(random.between(0.05, 1), random.between(0.05, 1),
                                             random.between(0.05, 1))};
    const OracleBox b{random.pose(0.8), Vec3(random.between(0.05, 1), random.between(0.05, 1),
                                             random.between(0.05, 1))};
    const double tolerances[] = {0, 1e-6, 1e-3, 1e-2};
    check(a, random.vector(0.5), b, tolerances[i % 4], count);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(count.free, 1000);
  EXPECT_GT(count.hit, 1000);
}

TEST(Translation, BoxesOnALattice) {
  Random random(2);
  Count count;
  for (int i = 0; i < 6000; ++i) {
    const auto lattice_half = [&] {
      return Vec3(0.125 * Vec3(1 + random.below(8), 1 + random.below(8), 1 + random.below(8)));
    };
    const OracleBox a{Pose(Eigen::Translation3d(random.lattice_vector(1.5))), lattice_half()};
    const OracleBox b{Pose(Eigen::Translation3d(random.lattice_vector(1.5))), lattice_half()};
    Vec3 d = Vec3::Zero();
    d[random.below(3)] = random.lattice(0.5);
    check(a, d, b, 1e-6, count);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(count.free, 500);
  EXPECT_GT(count.hit, 500);
}

TEST(Translation, ThinWallsAreNeverJumpedOver) {
  Random random(3);
  Count count;
  for (int i = 0; i < 4000; ++i) {
    const double thickness = random.between(0.02, 0.15);
    const OracleBox wall{random.pose(0.3),
                         Vec3(random.between(0.5, 3), thickness / 2, random.between(0.5, 3))};
    const OracleBox part{
        random.pose(0.6),
        Vec3(random.between(0.01, 0.2), random.between(0.01, 0.2), random.between(0.01, 0.2))};
    check(part, random.vector(1), wall, 1e-3, count);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(count.free, 500);
  EXPECT_GT(count.hit, 500);
}

TEST(Translation, FarFromTheOrigin) {
  Random random(4);
  Count count;
  const Vec3 far(1e5, -8e4, 120);
  for (int i = 0; i < 3000; ++i) {
    OracleBox a{random.pose(0.8),
                Vec3(random.between(0.05, 1), random.between(0.05, 1), random.between(0.05, 1))};
    OracleBox b{random.pose(0.8),
                Vec3(random.between(0.05, 1), random.between(0.05, 1), random.between(0.05, 1))};
    a.X_WC.translation() += far;
    b.X_WC.translation() += far;
    check(a, random.vector(0.5), b, 1e-6, count);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
}

TEST(Translation, ShapesDrawnFarFromTheirOrigin) {
  // Georeferenced drawings: the bodies stand at the world's origin, their shapes do not.
  const Vec3 far(1e5, 2e5, 30);
  const BodyPtr slab = prepare({box_shape(far, far + Vec3(6, 6, 0.2))});
  const BodyPtr panel = prepare({box_shape(far + Vec3(1, 1, 0.2), far + Vec3(3, 1.2, 3.2))});
  const Pose X = Pose::Identity();
  EXPECT_FALSE(blocked(*panel, geometry::translating(X, Vec3(0.5, 0.25, 0)), slab, X, 1e-6));
  EXPECT_TRUE(blocked(*panel, geometry::translating(X, Vec3(0.5, 0.25, -1e-5)), slab, X, 1e-6));
}

TEST(Translation, ToleranceZeroStillAllowsTouch) {
  const BodyPtr cube = box(Vec3::Constant(0.5));
  const Motion slide = geometry::translating(at(0.1, 0.3, 1), Vec3(0.7, 0.1, 0));
  EXPECT_FALSE(blocked(*cube, slide, cube, at(0, 0, 0), 0));
  EXPECT_TRUE(blocked(*cube, geometry::translating(at(0.1, 0.3, 1), Vec3(0, 0, -1e-6)), cube,
                      at(0, 0, 0), 0));
}

TEST(Translation, WaysOfAnyLengthFromADeepStartAreHits) {
  Random random(31);
  for (int i = 0; i < 400; ++i) {
    const BodyPtr cube = box(Vec3::Constant(0.05));
    const BodyPtr other = box(Vec3::Constant(0.05));
    const Pose X = at(0.02, 0.03, 0.04);
    const Vec3 direction = random.direction();
    for (const double length : {1e-300, 1e-161, 1e-100, 1e-20, 1e6, 1e14, 1e16, 1e18}) {
      EXPECT_TRUE(blocked(*cube, geometry::translating(X, length * direction), other,
                          Pose::Identity(), 1e-3))
          << length;
    }
  }
}

}  // namespace
}  // namespace rubicon::collision::test
