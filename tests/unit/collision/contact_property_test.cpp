#include <gtest/gtest.h>

#include "src/motion/collision/pair/body_depth.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/bodies.hpp"
#include "tests/unit/collision/box_oracle.hpp"
#include "tests/unit/collision/random_scene.hpp"
#include "tests/unit/collision/two_joint_motion.hpp"

namespace rubicon::collision::test {
namespace {

struct Hit {
  BodyPtr a;
  Motion motion;
  BodyPtr b;
  Pose X_WB;
  Contact contact;
};

/// Calls `check` with random steps that are hits.
template <typename Check>
int for_each_hit(std::uint32_t seed, int cases, const Check& check) {
  Random random(seed);
  int hits = 0;
  for (int i = 0; i < cases; ++i) {
    Hit hit{random_body(random), random_motion(random), random_body(random), random.pose(1), {}};
    CollisionWorld world;
    const ObstacleId id = world.insert(hit.b, hit.X_WB);
    SweptQuery query;
    query.items = {item(*hit.a, hit.motion)};
    query.contact_tolerance = kTolerance;
    const SweptResult result = world.test(query);
    if (!result.hit) continue;
    ++hits;
    EXPECT_EQ(result.hit->obstacle, id);
    hit.contact = world.contact(query, *result.hit);
    SCOPED_TRACE(testing::Message() << "case " << i);
    check(hit);
  }
  return hits;
}

TEST(ContactProperty, TheStepIsFreeUpToTheFractionAndBlockedABitBeyond) {
  int later = 0;
  const int hits = for_each_hit(501, 3000, [&](const Hit& hit) {
    const double fraction = hit.contact.fraction;
    ASSERT_GE(fraction, 0);
    ASSERT_LE(fraction, 1);
    if (fraction > 0) {
      ++later;
      // A whisker for the rounding of the other pose at the end.
      EXPECT_FALSE(
          blocked(*hit.a, part_of(hit.motion, 0, fraction), hit.b, hit.X_WB, kTolerance + 1e-8))
          << fraction;
    }
    // Undecided is called a hit within 0.01 mm of the tolerance: so much less for a part.
    const double beyond = std::min(1.0, fraction + 2.1e-4);
    EXPECT_TRUE(blocked(*hit.a, part_of(hit.motion, 0, beyond), hit.b, hit.X_WB, kTolerance - 3e-5))
        << fraction;
  });
  EXPECT_GT(hits, rubicon::test::at_least(500));
  EXPECT_GT(later, rubicon::test::at_least(100));
}

TEST(ContactProperty, TheWitnessIsAPointOfBothBodies) {
  // A small ball about the witness meets both; where they only touch it may lie between them.
  const BodyPtr ball =
      prepare({{geometry::Sphere{Vec3::Zero(), kTolerance + 1e-4}, Pose::Identity()}});
  const int hits = for_each_hit(502, 3000, [&](const Hit& hit) {
    const Pose X_ball(Eigen::Translation3d(hit.contact.point_W));
    EXPECT_TRUE(overlaps(*ball, X_ball, *hit.b, hit.X_WB, 0)) << hit.contact.fraction;
    EXPECT_TRUE(overlaps(*ball, X_ball, *hit.a, hit.motion.pose(hit.contact.fraction), 0))
        << hit.contact.fraction;
  });
  EXPECT_GT(hits, rubicon::test::at_least(500));
}

TEST(ContactProperty, TheFractionOfBoxesIsWhereTheExactSweptDepthPassesTheTolerance) {
  Random random(503);
  int hits = 0;
  for (int i = 0; i < rubicon::test::cases(5000); ++i) {
    const OracleBox a{random.pose(1), Vec3(0.2, 0.4, 0.1) + random.vector(0.08)};
    const OracleBox b{random.pose(1), Vec3(0.3, 0.2, 0.5) + random.vector(0.15)};
    const Vec3 d = random.vector(1);
    if (box_depth(a, b) > kTolerance || swept_box_depth(a, d, b) < kTolerance + 1e-6) continue;
    ++hits;
    double free = 0;
    double deep = 1;
    while (deep - free > 1e-9) {
      const double middle = 0.5 * (free + deep);
      (swept_box_depth(a, middle * d, b) > kTolerance ? deep : free) = middle;
    }
    CollisionWorld world;
    const ObstacleId id = world.insert(box(b.half), b.X_WC);
    const BodyPtr body = box(a.half);
    SweptQuery query;
    query.items = {item(*body, geometry::translating(a.X_WC, d))};
    const Contact contact = world.contact(query, SweptHit{0, id, std::nullopt});
    EXPECT_LE(contact.fraction, free + 1e-6) << "case " << i;
    EXPECT_GE(contact.fraction, free - 1.1e-4) << "case " << i;
  }
  EXPECT_GT(hits, rubicon::test::at_least(200));
}

TEST(ContactProperty, TheDepthOfBoxesIsTheLeastOverlapOfTheirAxes) {
  Random random(505);
  int deep = 0;
  for (int i = 0; i < rubicon::test::cases(2000); ++i) {
    const OracleBox a{random.pose(0.5), Vec3(0.2, 0.4, 0.1) + random.vector(0.08)};
    const OracleBox b{random.pose(0.5), Vec3(0.3, 0.2, 0.5) + random.vector(0.15)};
    const Vec3 d = random.vector(0.3);
    const BodyPtr moving = box(a.half);
    const BodyPtr standing = box(b.half);
    for (const double share : {0.0, 0.3, 1.0}) {
      OracleBox there = a;
      there.X_WC.translation() += share * d;
      const double depth = body_depth({moving.get(), geometry::translating(a.X_WC, d)},
                                      {standing.get(), geometry::stationary(b.X_WC)}, share);
      const double exact = std::max(box_depth(there, b), 0.0);
      EXPECT_LE(depth, exact + 1e-9) << "case " << i;
      EXPECT_GE(depth, exact - 2e-6) << "case " << i;
      deep += exact > 0.05 ? 1 : 0;
    }
  }
  EXPECT_GT(deep, rubicon::test::at_least(500));
}

TEST(ContactProperty, GeneralMotionsToo) {
  Random random(504);
  int hits = 0;
  for (int i = 0; i < rubicon::test::cases(2000); ++i) {
    TwoJointMotion crane;
    crane.theta0 = random.between(-3, 0);
    crane.theta1 = crane.theta0 + random.between(-6, 6);
    crane.place0 = Vec3(10, 0, 0) + random.vector(1);
    crane.place1 = crane.place0 + random.vector(0.5);
    const BodyPtr load = box(Vec3(0.3, 0.4, 0.2));
    const OracleBox wall{random.pose(0.5), Vec3(0.05, 1, 1)};
    Pose X = wall.X_WC;
    X.translation() += Vec3(10, 0, 0);
    CollisionWorld world;
    const ObstacleId id = world.insert(box(wall.half), X);
    SweptQuery query;
    query.items = {item(*load, crane.motion())};
    const auto depth_at = [&](double s) {
      return box_depth({crane.pose(s), Vec3(0.3, 0.4, 0.2)}, {X, wall.half});
    };
    if (depth_at(0) > kTolerance || !world.test(query).hit) continue;
    ++hits;
    const Contact contact = world.contact(query, SweptHit{0, id, std::nullopt});
    for (int k = 0; k < 50; ++k) {
      EXPECT_LE(depth_at(contact.fraction * k / 50.0), kTolerance + 1e-6) << "case " << i;
    }
    // A hit is called within 0.01 mm of the tolerance.
    double deepest = depth_at(contact.fraction);
    for (int k = 0; k <= 20; ++k)
      deepest = std::max(deepest, depth_at(std::min(1.0, contact.fraction + 2e-4 * k / 20.0)));
    EXPECT_GT(deepest, kTolerance - 1e-4) << "case " << i << " " << contact.fraction;
  }
  EXPECT_GT(hits, rubicon::test::at_least(100));
}

TEST(ContactProperty, EveryHitHasOneAlsoAtTheVeryTolerance) {
  int hits = 0;
  for (int i = 0; i < rubicon::test::cases(2000); ++i) {
    // Lowered onto each other by just the tolerance, in decimals that are not exact.
    const double height = 0.1 + 0.01 * (i % 50);
    const double gap = 0.003 * (i / 50);
    const BodyPtr body = prepare({box_shape(Vec3(0, 0, 0), Vec3(0.3, 0.3, height))});
    CollisionWorld world;
    world.insert(prepare({box_shape(Vec3(-1, -1, -0.2), Vec3(1, 1, 0))}), Pose::Identity());
    SweptQuery query;
    query.items = {item(*body, geometry::translating(at(0, 0, gap), Vec3(0, 0, -gap - 1e-3)))};
    if (!world.test(query).hit) continue;
    ++hits;
    ASSERT_EQ(world.explain(query).size(), 1U) << i;
  }
  EXPECT_GT(hits, 10);
}

}  // namespace
}  // namespace rubicon::collision::test
