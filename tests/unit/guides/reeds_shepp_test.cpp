#include "src/motion/guides/reeds_shepp.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/random.hpp"
#include "src/motion/math/turns.hpp"
#include "tests/support/random_cases.hpp"

namespace rubicon::guides {
namespace {

using rubicon::test::cases;

double length(const PlanePose& from, const PlanePose& to, double radius) {
  return reeds_shepp_way(from, to, radius).length();
}

PlanePose random_pose(math::Random& random, double most) {
  const double x = random.between(-most, most);
  const double y = random.between(-most, most);
  return {x, y, random.between(-180, 180)};
}

/// Where a way leads, by many short straight pieces, each along the heading in its middle.
PlanePose driven(PlanePose pose, const ReedsSheppWay& way) {
  constexpr int kPieces = 4000;
  for (const PlanePart& part : way.parts) {
    for (int i = 0; i < kPieces; ++i) {
      const double middle = math::radians(pose.heading_deg + part.turned_deg / kPieces / 2);
      pose.x += part.driven / kPieces * std::cos(middle);
      pose.y += part.driven / kPieces * std::sin(middle);
      pose.heading_deg += part.turned_deg / kPieces;
    }
  }
  return pose;
}

TEST(ReedsShepp, WaysThatAreKnown) {
  EXPECT_NEAR(length({0, 0, 0}, {10, 0, 0}, 3), 10, 1e-12);
  EXPECT_NEAR(length({0, 0, 0}, {-10, 0, 0}, 3), 10, 1e-12);
  // A quarter of a circle, ahead and back.
  EXPECT_NEAR(length({0, 0, 0}, {3, 3, 90}, 3), 3 * math::kPi / 2, 1e-9);
  EXPECT_NEAR(length({3, 3, 90}, {0, 0, 0}, 3), 3 * math::kPi / 2, 1e-9);
  // Turned about in three arcs of 60 degrees.
  EXPECT_NEAR(length({0, 0, 0}, {0, 0, 180}, 2), 2 * math::kPi, 1e-9);
  EXPECT_EQ(reeds_shepp_way({1, 2, 30}, {1, 2, 30}, 2).parts.size(), 0u);
  const ReedsSheppWay about = reeds_shepp_way({0, 0, 0}, {0, 0, 180}, 2);
  ASSERT_EQ(about.parts.size(), 3u);
  for (const PlanePart& part : about.parts) EXPECT_NEAR(std::fabs(part.turned_deg), 60, 1e-6);
}

TEST(ReedsShepp, WaysEndWhereTheyShallAndTurnNoNarrower) {
  math::Random random(5);
  for (int i = 0; i < cases(300); ++i) {
    const double radius = random.between(0.5, 8);
    const PlanePose from = random_pose(random, 20);
    const PlanePose to = random_pose(random, i % 2 == 0 ? 20 : 2);
    const ReedsSheppWay way = reeds_shepp_way(from, to, radius);
    ASSERT_FALSE(way.parts.empty());
    const PlanePose end = driven(from, way);
    EXPECT_NEAR(end.x, to.x, 1e-4);
    EXPECT_NEAR(end.y, to.y, 1e-4);
    EXPECT_NEAR(math::normalised_deg(end.heading_deg - to.heading_deg), 0, 1e-6);
    for (const PlanePart& part : way.parts) {
      if (part.turned_deg == 0) continue;
      EXPECT_NEAR(std::fabs(part.driven), radius * math::radians(std::fabs(part.turned_deg)), 1e-9);
    }
  }
}

/// What is left may not be more than a piece and what is left after it, for any piece that the
/// vehicle can drive. If that holds everywhere, no way is shorter: a family that was left out, or a
/// word that is not the shortest, breaks it.
TEST(ReedsShepp, NoPieceLeadsOnAShorterWay) {
  math::Random random(7);
  constexpr double kPiece = 0.05;
  int tight = 0;
  for (int i = 0; i < cases(10000); ++i) {
    const PlanePose from = random_pose(random, i % 3 == 0 ? 6 : 2.5);
    const PlanePose to{0, 0, 0};
    const double whole = length(from, to, 1);
    double best = 1e9;
    for (const double direction : {1.0, -1.0}) {
      for (const double turn : {0.0, 1.0, -1.0}) {
        const PlanePart piece{turn * direction * math::degrees(kPiece), direction * kPiece};
        const double left = length(after(from, piece), to, 1);
        ASSERT_LE(whole, kPiece + left + 1e-6)
            << from.x << ' ' << from.y << ' ' << from.heading_deg;
        best = std::min(best, kPiece + left);
      }
    }
    if (best - whole < 1e-6) ++tight;
  }
  // Where the first part is longer than the piece, one of the six is the beginning of the way.
  EXPECT_GT(tight, cases(10000) * 8 / 10);
}

TEST(ReedsShepp, TheWayBackIsAsLong) {
  math::Random random(9);
  for (int i = 0; i < cases(2000); ++i) {
    const PlanePose a = random_pose(random, 5);
    const PlanePose b = random_pose(random, 5);
    EXPECT_NEAR(length(a, b, 1.5), length(b, a, 1.5), 1e-6);
  }
}

}  // namespace
}  // namespace rubicon::guides
