#include <gtest/gtest.h>

#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/fcl_oracle.hpp"
#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {
namespace {

using Kind = FclSolid::Kind;

FclSolid random_solid(Random& random, Kind kind) {
  FclSolid solid;
  solid.kind = kind;
  solid.half =
      Vec3(random.between(0.05, 0.8), random.between(0.05, 0.8), random.between(0.05, 0.8));
  return solid;
}

/// Whether `a` less the tolerance meets `b` at some of many poses: then the step must be refused.
bool surely_deep(const FclSolid& a, const Motion& motion, const FclSolid& b, const Pose& X_WB) {
  constexpr int kPoses = 40;
  for (int i = 0; i <= kPoses; ++i) {
    if (fcl_collide(a, motion.pose(i / double{kPoses}), -(kTolerance + kBand), b, X_WB))
      return true;
  }
  return false;
}

/// Whether `a`, larger by the band, stays clear of `b` all the way: then the step must be allowed.
bool surely_clear(const FclSolid& a, const Motion& motion, double speed, const FclSolid& b,
                  const Pose& X_WB, double s0, double s1) {
  const Pose middle = motion.pose(0.5 * (s0 + s1));
  if (!fcl_collide(a, middle, kBand + 0.5 * speed * (s1 - s0), b, X_WB)) return true;
  if (fcl_collide(a, middle, kBand, b, X_WB) || s1 - s0 < 1e-4) return false;
  return surely_clear(a, motion, speed, b, X_WB, s0, 0.5 * (s0 + s1)) &&
         surely_clear(a, motion, speed, b, X_WB, 0.5 * (s0 + s1), s1);
}

class RoundShapes : public testing::TestWithParam<std::pair<Kind, Kind>> {};

TEST_P(RoundShapes, AgreeWithFclAtManyPoses) {
  const auto [kind_a, kind_b] = GetParam();
  Random random(100 + 10 * static_cast<int>(kind_a) + static_cast<int>(kind_b));
  int clear = 0;
  int deep = 0;
  for (int i = 0; i < rubicon::test::cases(500); ++i) {
    const FclSolid a = random_solid(random, kind_a);
    const FclSolid b = random_solid(random, kind_b);
    const Pose X_WA = random.pose(1.0);
    const Pose X_WB = random.pose(1.0);
    const Vec3 axis = random.direction();
    const Vec3 point = random.vector(3);
    const double angle = random.between(-30, 30);
    const bool translates = i % 2 == 0;
    const Motion motion = translates ? geometry::translating(X_WA, random.vector(0.7))
                                     : turning(X_WA, axis, point, angle);
    const double speed = translates
                             ? (motion.pose(1).translation() - X_WA.translation()).norm()
                             : math::radians(std::fabs(angle)) *
                                   (axis.cross(X_WA.translation() - point).norm() + a.reach());
    const bool must_hit = surely_deep(a, motion, b, X_WB);
    const bool must_pass = !must_hit && surely_clear(a, motion, speed, b, X_WB, 0, 1);
    if (!must_hit && !must_pass) continue;
    ++(must_hit ? deep : clear);
    EXPECT_EQ(blocked(*prepare({a.shape()}), motion, prepare({b.shape()}), X_WB, kTolerance),
              must_hit)
        << "case " << i;
  }
  EXPECT_GT(clear, rubicon::test::at_least(80));
  EXPECT_GT(deep, rubicon::test::at_least(80));
}

INSTANTIATE_TEST_SUITE_P(Kinds, RoundShapes,
                         testing::Values(std::pair(Kind::kBox, Kind::kSphere),
                                         std::pair(Kind::kBox, Kind::kCapsule),
                                         std::pair(Kind::kBox, Kind::kCylinder),
                                         std::pair(Kind::kSphere, Kind::kCapsule),
                                         std::pair(Kind::kCapsule, Kind::kCapsule),
                                         std::pair(Kind::kCapsule, Kind::kCylinder),
                                         std::pair(Kind::kCylinder, Kind::kCylinder),
                                         std::pair(Kind::kCylinder, Kind::kBox),
                                         std::pair(Kind::kSphere, Kind::kSphere),
                                         std::pair(Kind::kSphere, Kind::kCylinder)));

BodyPtr sphere(double radius) {
  return prepare({{geometry::Sphere{Vec3::Zero(), radius}, Pose::Identity()}});
}
BodyPtr upright(double radius) {
  return prepare({{geometry::Cylinder{radius, -1, 1}, Pose::Identity()}});
}

TEST(RoundShapes, DepthOfSpheresIsExact) {
  Random random(21);
  for (int i = 0; i < rubicon::test::cases(300); ++i) {
    const double r1 = random.between(0.1, 2);
    const double r2 = random.between(0.1, 2);
    const Vec3 way = random.direction();
    for (const double tolerance : {1e-6, 1e-3, 1e-2}) {
      const auto answer = [&](double depth) {
        return overlaps(*sphere(r1), at(0, 0, 0), *sphere(r2),
                        Pose(Eigen::Translation3d(way * (r1 + r2 - depth))), tolerance);
      };
      EXPECT_FALSE(answer(tolerance - 1e-8));
      EXPECT_TRUE(answer(tolerance + 1e-8));
    }
  }
}

TEST(RoundShapes, DepthOfCylindersSideBySideIsExact) {
  // The direction of least overlap is neither a face nor an edge direction.
  Random random(22);
  for (int i = 0; i < rubicon::test::cases(300); ++i) {
    const double r1 = random.between(0.1, 0.9);
    const double r2 = random.between(0.1, 0.9);
    const double heading = random.between(0, 360);
    const Vec3 way(math::cos_deg(heading), math::sin_deg(heading), 0);
    for (const double tolerance : {1e-6, 1e-3, 1e-2}) {
      const auto answer = [&](double depth) {
        return overlaps(*upright(r1), at(0, 0, 0), *upright(r2),
                        Pose(Eigen::Translation3d(way * (r1 + r2 - depth))), tolerance);
      };
      EXPECT_FALSE(answer(0.9 * tolerance));
      EXPECT_TRUE(answer(1.1 * tolerance));
    }
  }
}

TEST(RoundShapes, ACylinderAgainstTheEdgeOfABoxIsExact) {
  Random random(23);
  for (int i = 0; i < rubicon::test::cases(300); ++i) {
    const double radius = random.between(0.1, 0.9);
    const BodyPtr block = box(Vec3(1, 1, 3));
    // Towards the vertical edge at (1, 1), from within its corner of space.
    const double heading = random.between(10, 80);
    const Vec3 way(math::cos_deg(heading), math::sin_deg(heading), 0);
    for (const double tolerance : {1e-6, 1e-3}) {
      const auto answer = [&](double depth) {
        const Vec3 place = Vec3(1, 1, 0) + way * (radius - depth);
        return overlaps(*upright(radius), Pose(Eigen::Translation3d(place)), *block, at(0, 0, 0),
                        tolerance);
      };
      EXPECT_FALSE(answer(0.9 * tolerance)) << radius << " " << heading;
      EXPECT_TRUE(answer(1.1 * tolerance)) << radius << " " << heading;
    }
  }
}

TEST(RoundShapes, RestingAndSlidingOnASlabIsFree) {
  const BodyPtr slab = box(Vec3(10, 10, 0.1));
  const BodyPtr capsule =
      prepare({{geometry::Capsule{Vec3(-1, 0, 0), Vec3(1, 0, 0), 0.2}, Pose::Identity()}});
  const BodyPtr lying = prepare({{geometry::Cylinder{0.2, -1, 1}, math::rotation_y_deg(90)}});
  for (const BodyPtr& body : {sphere(0.2), capsule, lying}) {
    const Motion slide = geometry::translating(at(0.3, 0.1, 0.3), Vec3(0.4, 0.3, 0));
    const Motion turn = turning(at(0.3, 0.1, 0.3), Vec3::UnitZ(), Vec3(4, 3, 0), 5);
    EXPECT_FALSE(blocked(*body, slide, slab, at(0, 0, 0), 1e-6));
    EXPECT_FALSE(blocked(*body, turn, slab, at(0, 0, 0), 1e-6));
    EXPECT_TRUE(blocked(*body, slide, slab, at(0, 0, 1e-5), 1e-6));
    EXPECT_TRUE(blocked(*body, turn, slab, at(0, 0, 1e-5), 1e-6));
  }
}

}  // namespace
}  // namespace rubicon::collision::test
