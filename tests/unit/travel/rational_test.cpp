#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/motion/travel/travel.hpp"
#include "tests/unit/travel/rational_bugs.hpp"
#include "tests/unit/travel/travel_worlds.hpp"

namespace rubicon::travel {
namespace {

/// Boxes that touch in corners, along sides and along parts of sides, all on the lattice.
std::vector<Corners> touching_world(TestRandom& random) {
  std::vector<Corners> world;
  world.reserve(12);
  for (int i = 0; i < 12; ++i) {
    world.push_back(box(4 * random.whole(-4, 3), 4 * random.whole(-4, 3), 4 * random.whole(1, 2),
                        4 * random.whole(1, 2)));
  }
  return world;
}

TEST(Rational, BugsAndOutlinesAreThoseOfRationalArithmetic) {
  TestRandom random(51);
  int compared = 0;
  int reached = 0;
  for (int i = 0; i < cases(250); ++i) {
    SCOPED_TRACE(i);
    const auto world = i % 5 == 4
                           ? touching_world(random)
                           : random_world(random, static_cast<WorldKind>(i % 5), 3 + i % 8, 15);
    std::vector<Ring> rings;
    rings.reserve(world.size());
    for (const Corners& corners : world) rings.push_back(ring_of(corners));
    // On the lattice, so that lines to the destination go through corners and along edges.
    const Vec2 start = i % 2 == 0 ? Vec2(random.whole(-5, 5) * 4, -24)
                                  : Vec2(random.whole(-16, 16), random.whole(-16, 16));
    const Vec2 destination(random.whole(-16, 16), random.whole(-16, 20));
    const Outline outline(pieces_of(world));
    if (outline.place_of(snap(start)) >= 0 || start == destination) continue;
    ++compared;

    std::vector<double> lengths;
    for (const Composite& composite : outline.composites()) {
      for (const Loop& loop : composite.loops) lengths.push_back(loop.length);
    }
    std::sort(lengths.begin(), lengths.end());
    const std::vector<double> exact_lengths = rational_loops(rings);
    ASSERT_EQ(lengths.size(), exact_lengths.size());
    for (std::size_t k = 0; k < lengths.size(); ++k)
      EXPECT_NEAR(lengths[k], exact_lengths[k], 1e-9);

    const TravelQuery query = query_of(world, start, destination);
    const OracleResult exact2 = rational_bug2(rings, snap(start), snap(destination));
    const TravelResult bug2 = travel(Method::kBug2, query);
    EXPECT_EQ(bug2.verdict == Verdict::kReached, exact2.reached) << told(bug2);
    EXPECT_NEAR(bug2.length, exact2.length, 1e-9) << told(bug2);
    const OracleResult exact1 = rational_bug1(rings, snap(start), snap(destination));
    const TravelResult bug1 = travel(Method::kBug1, query);
    EXPECT_EQ(bug1.verdict == Verdict::kReached, exact1.reached) << told(bug1);
    EXPECT_NEAR(bug1.length, exact1.length, 1e-9) << told(bug1);
    reached += exact2.reached ? 1 : 0;
  }
  EXPECT_GT(compared, cases(250) / 2);
  EXPECT_GT(reached, compared / 3);
  EXPECT_LT(reached, compared);
  RecordProperty("compared", compared);
  RecordProperty("reached", reached);
}

}  // namespace
}  // namespace rubicon::travel
