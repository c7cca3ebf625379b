#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/bodies.hpp"
#include "tests/unit/collision/exact_distance.hpp"
#include "tests/unit/collision/two_joint_motion.hpp"

namespace rubicon::collision::test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Rounding of distances (m).
constexpr double kRounding = 1e-9;
constexpr int kPoses = 400;

/// What dense poses say of the least distance over a step: not more than `most`, and less by no
/// more than the motion between two poses.
struct Sampled {
  double least = 0;
  double most = kInfinite;
};

template <typename Distance>
Sampled sampled(const Distance& distance, double speed) {
  Sampled result;
  for (int i = 0; i <= kPoses; ++i)
    result.most = std::min(result.most, distance(i / double{kPoses}));
  result.least = std::max(0.0, result.most - 0.5 * speed / kPoses);
  return result;
}

Motion any_short_motion(Random& random) {
  if (random.below(4)) return random_motion(random);
  TwoJointMotion crane;
  crane.theta0 = random.between(-5, 5);
  crane.theta1 = crane.theta0 + random.between(-5, 5);
  crane.place0 = Vec3(3, 0, 0) + random.vector(1);
  crane.place1 = crane.place0 + random.vector(0.4);
  return crane.motion();
}

void check(const Clearance& found, const Sampled& truth, double range, double resolution,
           bool is_general) {
  if (found.lower_bound == kInfinite) {
    EXPECT_GE(truth.most, range - kRounding);
    return;
  }
  EXPECT_LE(found.lower_bound, truth.most + kRounding);
  EXPECT_LE(found.lower_bound, found.upper_bound);
  EXPECT_GE(found.upper_bound, truth.least - kRounding);
  if (!is_general) {
    EXPECT_LE(found.upper_bound - found.lower_bound, resolution + kRounding);
  }
}

TEST(ClearanceProperty, HoldsTheExactDistanceOfBoxes) {
  Random random(601);
  int apart = 0;
  for (int i = 0; i < rubicon::test::cases(250); ++i) {
    const Vec3 half = Vec3(0.3, 0.3, 0.3) + random.vector(0.25);
    const Motion motion = any_short_motion(random);
    const bool is_general = motion.kind.index() == 1;
    OracleBox wall{random.pose(1.5), Vec3(0.4, 0.4, 0.4) + random.vector(0.35)};
    if (is_general) wall.X_WC.translation().x() += 3;
    const double range = i % 3 ? 5 : 0.3;
    const double resolution = i % 2 ? 1e-3 : 1e-4;
    CollisionWorld world;
    const ObstacleId id = world.insert(box(wall.half), wall.X_WC);
    const BodyPtr body = box(half);
    SweptQuery query;
    query.items = {item(*body, motion)};
    const Clearance found = world.clearance(query, range, resolution);
    const Sampled truth = sampled(
        [&](double s) {
          return box_distance({motion.pose(s), half}, wall);
        },
        speed_of(motion, half.norm()));
    SCOPED_TRACE(testing::Message() << "case " << i);
    check(found, truth, range, resolution, is_general);
    if (found.lower_bound == kInfinite) continue;
    ASSERT_TRUE(found.pair);
    EXPECT_EQ(found.pair->obstacle, id);
    if (found.lower_bound <= 0) continue;
    ++apart;
    // The points are those of the bodies at that moment.
    EXPECT_NEAR((found.point_moving_W - found.point_met_W).norm(), found.upper_bound, 1e-8);
    EXPECT_LE(point_box_distance(found.point_met_W, wall), 1e-8);
    EXPECT_LE(point_box_distance(found.point_moving_W, {motion.pose(found.fraction), half}), 1e-8);
  }
  EXPECT_GT(apart, rubicon::test::at_least(50));
}

TEST(ClearanceProperty, HoldsTheExactDistanceOfCapsules) {
  Random random(602);
  int apart = 0;
  for (int i = 0; i < rubicon::test::cases(1200); ++i) {
    const double r1 = random.between(0.05, 0.4);
    const double r2 = random.between(0.05, 0.4);
    const double l1 = random.between(0.1, 1);
    const double l2 = random.between(0.1, 1);
    const auto capsule = [](double radius, double half) {
      return prepare(
          {{geometry::Capsule{Vec3(0, 0, -half), Vec3(0, 0, half), radius}, Pose::Identity()}});
    };
    const Motion motion = random_motion(random);
    const Pose X = random.pose(1.5);
    CollisionWorld world;
    world.insert(capsule(r2, l2), X);
    const BodyPtr body = capsule(r1, l1);
    SweptQuery query;
    query.items = {item(*body, motion)};
    const Clearance found = world.clearance(query, 4, 1e-3);
    const Sampled truth = sampled(
        [&](double s) {
          const Pose X_a = motion.pose(s);
          return std::max(0.0, segment_distance(X_a * Vec3(0, 0, -l1), X_a * Vec3(0, 0, l1),
                                                X * Vec3(0, 0, -l2), X * Vec3(0, 0, l2)) -
                                   r1 - r2);
        },
        speed_of(motion, r1 + l1));
    SCOPED_TRACE(testing::Message() << "case " << i);
    check(found, truth, 4, 1e-3, false);
    apart += found.lower_bound > 0;
  }
  EXPECT_GT(apart, rubicon::test::at_least(300));
}

TEST(ClearanceProperty, TheNearestOfManyCounts) {
  Random random(603);
  for (int i = 0; i < 2; ++i) {
    std::vector<OracleBox> walls;
    CollisionWorld world;
    for (int k = 0; k < 40; ++k) {
      walls.push_back({random.pose(4), Vec3(0.3, 0.3, 0.3) + random.vector(0.25)});
      world.insert(box(walls.back().half), walls.back().X_WC);
    }
    const Vec3 half(0.1, 0.2, 0.15);
    const BodyPtr body = box(half);
    for (int k = 0; k < 5; ++k) {
      const Motion motion = random_motion(random);
      SweptQuery query;
      query.items = {item(*body, motion)};
      query.ignore = {static_cast<ObstacleId>(1 + random.below(40))};
      const Clearance found = world.clearance(query, 10, 1e-3);
      Sampled truth;
      truth.least = kInfinite;
      for (std::size_t wall = 0; wall < walls.size(); ++wall) {
        if (wall + 1 == query.ignore.front()) continue;
        const Sampled one = sampled(
            [&](double s) {
              return box_distance({motion.pose(s), half}, walls[wall]);
            },
            speed_of(motion, half.norm()));
        truth.least = std::min(truth.least, one.least);
        truth.most = std::min(truth.most, one.most);
      }
      SCOPED_TRACE(testing::Message() << "case " << i << " query " << k);
      check(found, truth, 10, 1e-3, false);
    }
  }
}

TEST(ClearanceProperty, ABlockedStepHasNone) {
  Random random(604);
  int blocked_steps = 0;
  for (int i = 0; i < rubicon::test::cases(1000); ++i) {
    const BodyPtr a = random_body(random);
    const BodyPtr b = random_body(random);
    const Motion motion = random_motion(random);
    const Pose X = random.pose(1);
    CollisionWorld world;
    world.insert(b, X);
    SweptQuery query;
    query.items = {item(*a, motion)};
    const Clearance found = world.clearance(query, 1);
    if (world.test(query).hit) {
      ++blocked_steps;
      EXPECT_EQ(found.lower_bound, 0) << "case " << i;
    }
    if (found.lower_bound > 0) {
      EXPECT_FALSE(world.test(query).hit) << "case " << i;
    }
  }
  EXPECT_GT(blocked_steps, rubicon::test::at_least(200));
}

}  // namespace
}  // namespace rubicon::collision::test
