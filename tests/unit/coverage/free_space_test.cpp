#include "src/motion/coverage/free_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/coverage/random_floors.hpp"

namespace rubicon::coverage {
namespace {

/// A hall of 30 x 20 m with a ring of columns that a tool with a clearance of 0.25 m does not get
/// through, and columns anywhere else.
FloorDescription hall_with_a_ring(FloorRandom& random) {
  FloorDescription floor;
  floor.outline = box(0, 0, 30, 20);
  const auto add_column = [&](double x, double y) {
    floor.columns.push_back({"", {x, y}, 0.5, false});
    if (!faults_of(floor, {}).empty()) floor.columns.pop_back();
  };
  for (double along = 8; along <= 13; along += 0.8) {
    for (const double across : {8.0, 12.8}) {
      add_column(along, across);
      add_column(across, along);
    }
  }
  for (int i = 0; i < 25; ++i) {
    const double x = random.between(15, 29);
    add_column(x, random.between(1, 19));
  }
  return floor;
}

TEST(FreeSpace, ReachesWhatAShortestWayLeadsTo) {
  FloorRandom random(3);
  CoverageOptions options;
  options.clearance = 0.25;
  int reached = 0;
  int cut_off = 0;
  for (int round = 0; round < 4; ++round) {
    const FreeSpace space(make_floor(hall_with_a_ring(random), options), options.clearance);
    for (int pair = 0; pair < 40; ++pair) {
      // One of each pair at times inside the ring.
      const bool inside = pair % 4 == 0;
      const double ax = inside ? random.between(9, 12) : random.between(0, 30);
      const double ay = inside ? random.between(9, 12) : random.between(0, 20);
      const double bx = random.between(0, 30);
      const double by = random.between(0, 20);
      const Point a = snap({ax, ay});
      const Point b = snap({bx, by});
      if (!space.allows(a) || !space.allows(b)) continue;
      const bool there_is_a_way = std::isfinite(space.shortest_length(a, b));
      EXPECT_EQ(space.reaches(a, b), there_is_a_way);
      EXPECT_EQ(space.reaches(b, a), there_is_a_way);
      ++(there_is_a_way ? reached : cut_off);
    }
  }
  EXPECT_GT(reached, 30);
  EXPECT_GT(cut_off, 10);
}

}  // namespace
}  // namespace rubicon::coverage
