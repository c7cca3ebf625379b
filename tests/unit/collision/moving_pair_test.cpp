#include <gtest/gtest.h>

#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/box_oracle.hpp"
#include "tests/unit/collision/random_scene.hpp"
#include "tests/unit/collision/two_joint_motion.hpp"

namespace rubicon::collision::test {
namespace {

void check(const Vec3& half_a, const Motion& a, const Vec3& half_b, const Motion& b, Count& count) {
  const double speed = speed_of(a, half_a.norm()) + speed_of(b, half_b.norm());
  const Truth truth = classify(
      [&](double s) {
        return box_depth({a.pose(s), half_a}, {b.pose(s), half_b});
      },
      speed, kTolerance, kBand);
  if (truth == Truth::kNearBoundary) return;
  ++(truth == Truth::kHit ? count.hit : count.free);
  ASSERT_EQ(pair_blocked(*box(half_a), a, *box(half_b), b, kTolerance), truth == Truth::kHit);
  ASSERT_EQ(pair_blocked(*box(half_b), b, *box(half_a), a, kTolerance), truth == Truth::kHit);
}

Vec3 random_half(Random& random) {
  const double x = random.between(0.05, 0.6);
  const double y = random.between(0.05, 0.6);
  const double z = random.between(0.05, 0.6);
  return {x, y, z};
}

TEST(MovingPair, TwoTranslations) {
  // One of them, seen from the other, translates: the depth of that swept volume is exact.
  Random random(61);
  Count count;
  for (int i = 0; i < rubicon::test::cases(1500); ++i) {
    const OracleBox a{random.pose(1), random_half(random)};
    const OracleBox b{random.pose(1), random_half(random)};
    const Vec3 d_a = random.vector(0.5);
    const Vec3 d_b = random.vector(0.5);
    const double depth = swept_box_depth(a, d_a - d_b, b);
    if (std::fabs(depth - kTolerance) < 1e-7) continue;
    const bool expected = depth > kTolerance;
    ++(expected ? count.hit : count.free);
    ASSERT_EQ(pair_blocked(*box(a.half), geometry::translating(a.X_WC, d_a), *box(b.half),
                           geometry::translating(b.X_WC, d_b), kTolerance),
              expected)
        << "case " << i;
  }
  EXPECT_GT(count.free, rubicon::test::at_least(100));
  EXPECT_GT(count.hit, rubicon::test::at_least(100));
}

TEST(MovingPair, TwoScrewsAboutUnrelatedAxes) {
  Random random(62);
  Count count;
  for (int i = 0; i < rubicon::test::cases(1500); ++i) {
    const auto screw = [&] {
      return turning(random.pose(1), random.direction(), random.vector(2), random.between(-30, 30),
                     random.between(-0.3, 0.3));
    };
    const Motion a = screw();
    const Motion b = screw();
    check(random_half(random), a, random_half(random), b, count);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(count.free, rubicon::test::at_least(100));
  EXPECT_GT(count.hit, rubicon::test::at_least(100));
}

TEST(MovingPair, TwoScrewsAboutOneAxis) {
  Random random(63);
  Count count;
  for (int i = 0; i < rubicon::test::cases(1500); ++i) {
    const Vec3 axis = random.direction();
    const Vec3 point = random.vector(2);
    const Motion a =
        turning(random.pose(1), axis, point, random.between(-40, 40), random.between(-0.3, 0.3));
    const Motion b = i % 3 == 0
                         ? geometry::translating(random.pose(1), random.between(-0.5, 0.5) * axis)
                         : turning(random.pose(1), axis, point, random.between(-40, 40),
                                   random.between(-0.3, 0.3));
    check(random_half(random), a, random_half(random), b, count);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
}

TEST(MovingPair, GeneralAgainstScrewAndGeneral) {
  Random random(64);
  Count count;
  for (int i = 0; i < rubicon::test::cases(1500); ++i) {
    const auto crane = [&] {
      TwoJointMotion result;
      result.theta0 = random.between(-10, 10);
      result.theta1 = result.theta0 + random.between(-10, 10);
      result.place0 = Vec3(5, 0, 0) + random.vector(1);
      result.place1 = result.place0 + random.vector(0.5);
      return result.motion();
    };
    Pose X = random.pose(1);
    X.translation().x() += 5;
    const Motion a = crane();
    const Motion b =
        i % 2 ? crane() : turning(X, random.direction(), random.vector(5), random.between(-10, 10));
    check(random_half(random), a, random_half(random), b, count);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  EXPECT_GT(count.free, rubicon::test::at_least(100));
  EXPECT_GT(count.hit, rubicon::test::at_least(100));
}

TEST(MovingPair, AHookBesideItsJibIsNeverHitByItsOwnSlewing) {
  // 1 mm below the jib, 30 m out, slewing by 5 degrees: as one rigid thing, then with the trolley
  // running.
  const BodyPtr jib = prepare({box_shape(Vec3(0, -0.5, 0), Vec3(40, 0.5, 1))});
  const BodyPtr hook = prepare({box_shape(Vec3(-0.3, -0.3, -1), Vec3(0.3, 0.3, -0.001))});
  const Motion slewing_jib = turning(at(0, 0, 40), Vec3::UnitZ(), Vec3::Zero(), 5);
  EXPECT_FALSE(pair_blocked(*jib, slewing_jib, *hook,
                            turning(at(30, 0, 40), Vec3::UnitZ(), Vec3::Zero(), 5), 1e-6));
  EXPECT_TRUE(pair_blocked(*jib, slewing_jib, *hook,
                           turning(at(30, 0, 40.01), Vec3::UnitZ(), Vec3::Zero(), 5), 1e-6));
  TwoJointMotion trolley;
  trolley.theta1 = 5;
  trolley.place0 = Vec3(30, 0, 40);
  trolley.place1 = Vec3(30.5, 0, 40);
  EXPECT_FALSE(pair_blocked(*jib, slewing_jib, *hook, trolley.motion(), 1e-6));
  TwoJointMotion same_jib;
  same_jib.theta1 = 5;
  same_jib.place0 = same_jib.place1 = Vec3(0, 0, 40);
  EXPECT_FALSE(pair_blocked(*jib, same_jib.motion(), *hook, trolley.motion(), 1e-6));
  trolley.place1.z() = 40.02;  // hoists into the jib
  EXPECT_TRUE(pair_blocked(*jib, slewing_jib, *hook, trolley.motion(), 1e-6));
}

TEST(MovingPair, TheSagittaSeenFromATurningBodyCounts) {
  // B turns by 20 degrees about its own centre while A all but stands, 10 m away: in the frame of B
  // A runs along an arc that leaves its chord by 0.15 m. B's wall is reached only at mid step.
  const BodyPtr ball = prepare({{geometry::Sphere{Vec3::Zero(), 0.1}, Pose::Identity()}});
  const auto arms = [](double distance) {
    return prepare({box_shape(Vec3(distance, -0.05, -1), Vec3(distance + 0.5, 0.05, 1)),
                    box_shape(Vec3(-distance - 0.5, -0.05, -1), Vec3(-distance, 0.05, 1))});
  };
  const Motion drift = geometry::translating(at(10, 0, 0), Vec3(0, 0.001, 0));
  const Motion turn = turning(math::rotation_z_deg(-10), Vec3::UnitZ(), Vec3::Zero(), 20);
  EXPECT_TRUE(pair_blocked(*ball, drift, *arms(10.05), turn, 1e-3));
  EXPECT_FALSE(pair_blocked(*ball, drift, *arms(10.11), turn, 1e-3));
}

TEST(MovingPair, ThePathAcrossATurningBodyIsBent) {
  // A crosses the centre of B, which turns by 20 degrees meanwhile: seen from B, A comes from below
  // and goes below, 0.17 m, and is highest when it passes the centre, where B's lip hangs.
  const BodyPtr ball = prepare({{geometry::Sphere{Vec3::Zero(), 0.1}, Pose::Identity()}});
  const auto lips = [](double height) {
    return prepare({box_shape(Vec3(-0.1, height, -1), Vec3(0.1, height + 0.1, 1)),
                    box_shape(Vec3(-0.1, -height - 2, -1), Vec3(0.1, -height - 1.9, 1))});
  };
  const Motion crossing = geometry::translating(at(-1, 0, 0), Vec3(2, 0, 0));
  const Motion turn = turning(math::rotation_z_deg(-10), Vec3::UnitZ(), Vec3::Zero(), 20);
  EXPECT_TRUE(pair_blocked(*ball, crossing, *lips(0.05), turn, 1e-3));
  EXPECT_FALSE(pair_blocked(*ball, crossing, *lips(0.11), turn, 1e-3));
}

TEST(MovingPair, TogetherAndTouchingIsFreeWhateverTheMotion) {
  const BodyPtr cube = box(Vec3::Constant(0.5));
  const Vec3 d(0.3, 0.4, 0.1);
  EXPECT_FALSE(pair_blocked(*cube, geometry::translating(at(0, 0, 0), d), *cube,
                            geometry::translating(at(1, 0, 0), d), 1e-6));
  const auto turn = [](const Pose& X0) {
    return turning(X0, Vec3(0, 0.6, 0.8), Vec3(3, 2, 1), 30, 0.2);
  };
  EXPECT_FALSE(pair_blocked(*cube, turn(at(0, 0, 0)), *cube, turn(at(1, 0, 0)), 1e-6));
  TwoJointMotion crane;
  crane.theta1 = 8;
  crane.place0 = Vec3(3, 0, 0);
  crane.place1 = Vec3(3.5, 0.2, 0);
  TwoJointMotion beside = crane;
  beside.place0.y() += 1;
  beside.place1.y() += 1;
  EXPECT_FALSE(pair_blocked(*cube, crane.motion(), *cube, beside.motion(), 1e-3));
}

}  // namespace
}  // namespace rubicon::collision::test
