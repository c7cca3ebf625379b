#include "src/motion/travel/visibility.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/unit/travel/fixtures.hpp"
#include "tests/unit/travel/rational_bugs.hpp"
#include "tests/unit/travel/travel_worlds.hpp"

namespace rubicon::travel {
namespace {

TEST(Visibility, GoesRoundABoxAndOutOfAU) {
  const VisibilityResult round_box =
      shortest_way(query_of({box(-10, 0, 20, 10)}, {0, -20}, {0, 30}));
  EXPECT_TRUE(round_box.reached);
  EXPECT_NEAR(round_box.length, std::sqrt(500.0) + 10 + std::sqrt(500.0), 1e-12);
  EXPECT_EQ(round_box.way.size(), 4u);
  const VisibilityResult out_of_u =
      shortest_way(query_of({u_shape(-10, 0, 20, 20, 3)}, {0, 10}, {0, 40}));
  EXPECT_NEAR(out_of_u.length, std::sqrt(149.0) + 3 + 20 + std::sqrt(500.0), 1e-12);
  EXPECT_FALSE(shortest_way(query_of({box(-10, 0, 20, 10)}, {0, -40}, {0, 5})).reached);
}

TEST(Visibility, ThroughWhereObstaclesMeetThereIsNoWay) {
  // A ring of boxes that touch in corners, about the destination.
  const std::vector<Corners> ring = {box(-2, -6, 4, 4), box(2, -2, 4, 4), box(-2, 2, 4, 4),
                                     box(-6, -2, 4, 4)};
  const TravelQuery query = query_of(ring, {-8, -8}, {0, 0});
  EXPECT_FALSE(shortest_way(query).reached);
  for (const Method method : {Method::kBug1, Method::kBug2, Method::kVisBug21, Method::kTangent}) {
    EXPECT_EQ(travel(method, query).verdict, Verdict::kUnreachable) << name_of(method);
  }
}

TEST(Visibility, MovingObstaclesAreRefused) {
  EXPECT_THROW(shortest_way(figure_1()), std::invalid_argument);
  EXPECT_THROW(travel(Method::kBug1, figure_1()), std::invalid_argument);
  EXPECT_THROW(travel(Method::kVisBug21, figure_1()), std::invalid_argument);
}

TEST(Visibility, NoWayIsShorterThanTheShortest) {
  TestRandom random(61);
  int reached = 0;
  const int count = cases(150);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const auto world = random_world(random, static_cast<WorldKind>(i % 4), random.whole(2, 12), 15);
    const Vec2 start(random.whole(-20, 20), -30);
    const Vec2 destination(random.whole(-15, 15), random.whole(-15, 30));
    const TravelQuery query = query_of(world, start, destination);
    const VisibilityResult shortest = shortest_way(query);
    const VisibilityResult back = shortest_way(query_of(world, destination, start));
    EXPECT_EQ(shortest.reached, back.reached);
    EXPECT_NEAR(shortest.length, back.length, 1e-9);
    EXPECT_EQ(shortest.reached, travel(Method::kBug2, query).verdict == Verdict::kReached);
    reached += shortest.reached ? 1 : 0;
    for (const Method method : kMethods) {
      TravelSettings settings;
      settings.most_length = 5000;
      const TravelResult result = travel(method, query, settings);
      if (method == Method::kPledge || result.verdict != Verdict::kReached) continue;
      EXPECT_GE(result.length, shortest.length * (1 - 1e-9)) << name_of(method);
    }
  }
  EXPECT_GT(reached, count / 2);
  EXPECT_LT(reached, count);
}

TEST(Visibility, EqualsAllWaysOverAllCorners) {
  TestRandom random(62);
  int compared = 0;
  for (int i = 0; i < cases(120); ++i) {
    SCOPED_TRACE(i);
    std::vector<Corners> world;
    const int obstacles = random.whole(1, 3);
    for (int k = 0; k < obstacles; ++k) {
      const Vec2 centre(random.whole(-8, 8), random.whole(-8, 8));
      if (i % 3 == 0) {
        world.push_back(star(random, centre, 1, 6, random.whole(3, 6)));
      } else if (i % 3 == 1) {
        world.push_back(convex(random, centre, random.between(2, 6), random.whole(3, 5)));
      } else {
        world.push_back(u_shape(centre.x(), centre.y(), 6, 6, 1, random.whole(0, 3)));
      }
    }
    const Vec2 start(random.whole(-10, 10), random.whole(-16, -5));
    const Vec2 destination(random.whole(-10, 10), random.whole(-5, 16));
    const Outline outline(pieces_of(world));
    if (outline.work().built != obstacles || outline.covers(snap(start)) ||
        outline.covers(snap(destination)) || start == destination) {
      continue;
    }
    ++compared;
    std::vector<Ring> rings;
    rings.reserve(world.size());
    for (const Corners& corners : world) rings.push_back(ring_of(corners));
    const VisibilityResult shortest = shortest_way(query_of(world, start, destination));
    EXPECT_TRUE(shortest.reached);
    EXPECT_NEAR(shortest.length, rational_shortest(rings, snap(start), snap(destination)), 1e-9);
  }
  EXPECT_GT(compared, cases(120) / 3);
  RecordProperty("compared", compared);
}

}  // namespace
}  // namespace rubicon::travel
