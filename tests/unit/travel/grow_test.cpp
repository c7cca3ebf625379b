#include "src/motion/travel/grow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "src/motion/math/angles.hpp"
#include "tests/unit/travel/travel_worlds.hpp"

namespace rubicon::travel {
namespace {

double area_of(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = metres(ring[i]);
    const Vec2 b = metres(next_corner(ring, i));
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

double distance_to(const Vec2& p, const Corners& corners) {
  double least = 1e300;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2& a = corners[i];
    const Vec2 along = corners[(i + 1) % corners.size()] - a;
    const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - a - t * along).norm());
  }
  return least;
}

TEST(Ring, LeavesOutNeedlessCornersAndTurnsTheSense) {
  const Corners corners = {{0, 0}, {0, 4}, {0, 4}, {2, 4}, {4, 4}, {4, 0}};
  const Ring ring = ring_of(corners);
  EXPECT_EQ(ring.size(), 4u);
  EXPECT_DOUBLE_EQ(area_of(ring), 16);
}

TEST(Ring, RefusesWhatIsNoSimplePolygon) {
  const Corners line = {{0, 0}, {1, 0}, {2, 0}};
  const Corners bow = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  const Corners touching = {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}};
  EXPECT_THROW(ring_of(line), std::invalid_argument);
  EXPECT_THROW(ring_of(bow), std::invalid_argument);
  EXPECT_THROW(ring_of(touching), std::invalid_argument);
}

TEST(Grow, ABoxByABoxIsABox) {
  const Corners footprint = {{-1, -2}, {3, -2}, {3, 2}, {-1, 2}};
  const Ring ring = ring_of(grow(box(10, 10, 5, 4), footprint));
  // The robot reaches 3 m east of its reference point, so this stays 3 m west of the box.
  EXPECT_EQ(ring.size(), 4u);
  EXPECT_EQ(box_of(ring).low_x, snap({7, 0}).x);
  EXPECT_EQ(box_of(ring).high_x, snap({16, 0}).x);
  EXPECT_EQ(box_of(ring).low_y, snap({0, 8}).y);
  EXPECT_EQ(box_of(ring).high_y, snap({0, 16}).y);
}

TEST(Grow, ByADiscLiesWithinTheBound) {
  TestRandom random(4);
  for (int i = 0; i < 50; ++i) {
    const Corners shape = convex(random, {random.between(-9, 9), 3}, 5, random.whole(3, 9));
    const double radius = random.between(0.1, 3);
    const int sides = random.whole(3, 40);
    const double most = radius / math::cos_deg(180.0 / sides);
    for (const Vec2& corner : grow(shape, disc(radius, sides))) {
      EXPECT_GE(distance_to(corner, shape), radius * (1 - 1e-12));
      EXPECT_LE(distance_to(corner, shape), most * (1 + 1e-12));
    }
  }
}

TEST(Grow, PartsOfAShapeCoverItOnce) {
  TestRandom random(5);
  for (int i = 0; i < 100; ++i) {
    const Ring ring = ring_of(i % 2 == 0 ? star(random, {0, 0}, 1, 9, random.whole(4, 15))
                                         : u_shape(0, 0, random.whole(5, 9), 8, 2, i % 4));
    double total = 0;
    for (const Ring& part : convex_parts(ring)) total += area_of(part);
    EXPECT_NEAR(total, area_of(ring), 1e-9);
  }
}

TEST(Grow, AShapeThatIsNotConvexKeepsItsFreeSpace) {
  // A U of 10 by 8 with walls of 2, grown by half a metre: 5 m of the 6 between its arms remain.
  const Outline outline(grown_pieces(u_shape(0, 0, 10, 8, 2), box(-0.5, -0.5, 1, 1), 0));
  EXPECT_EQ(outline.composites().size(), 1u);
  EXPECT_EQ(outline.composites()[0].loops.size(), 1u);
  EXPECT_NEAR(outline.composites()[0].loops[0].length, 2 * (11 + 9) + 2 * 6, 1e-9);
  EXPECT_FALSE(outline.covers(snap({5, 5})));
  EXPECT_TRUE(outline.covers(snap({2.4, 3})));
}

}  // namespace
}  // namespace rubicon::travel
