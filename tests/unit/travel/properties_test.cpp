#include <gtest/gtest.h>

#include <string>

#include "src/motion/travel/travel.hpp"
#include "tests/unit/travel/travel_worlds.hpp"

namespace rubicon::travel {
namespace {

constexpr double kSlack = 1 + 1e-9;

/// A world of any kind, with the start in free space; the destination may be in an obstacle.
TravelQuery any_query(TestRandom& random, int which) {
  while (true) {
    const auto world =
        random_world(random, static_cast<WorldKind>(which % 4), random.whole(3, 25), 20);
    // Outside of all obstacles, or among them.
    const Vec2 start = which % 2 == 0 ? Vec2(random.whole(-30, 30), -40)
                                      : Vec2(random.whole(-25, 25), random.whole(-25, 25));
    const Vec2 destination(random.whole(-25, 25), random.whole(-25, 35));
    if (is_free(world, start)) return query_of(world, start, destination);
  }
}

TravelQuery maze_query(TestRandom& random) {
  const auto walls = wall_maze(random, 6, 4, random.between(0.2, 0.6));
  const auto cell = [&random] { return random.whole(-1, 6) * 4 + 2; };
  return query_of(walls, Vec2(cell(), cell()), Vec2(cell(), cell()));
}

TEST(Properties, BugsKeepTheirBoundsAndAgree) {
  TestRandom random(21);
  int reached = 0;
  const int count = cases(1000);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const TravelQuery query = any_query(random, i);
    const TravelResult bug1 = travel(Method::kBug1, query);
    const TravelResult bug2 = travel(Method::kBug2, query);
    EXPECT_EQ(bug1.verdict, bug2.verdict) << told(bug1) << " | " << told(bug2);
    EXPECT_NE(bug1.verdict, Verdict::kLimit);
    EXPECT_LE(bug1.length, bug1.bound->length * kSlack);
    EXPECT_LE(bug2.length, bug2.bound->length * kSlack);
    reached += bug2.verdict == Verdict::kReached ? 1 : 0;
  }
  EXPECT_GT(reached, count / 2);
  EXPECT_LT(reached, count);
}

TEST(Properties, AmongConvexObstaclesBug2GoesRoundEachAtMostOnce) {
  TestRandom random(22);
  for (int i = 0; i < cases(1000); ++i) {
    SCOPED_TRACE(i);
    std::vector<Corners> world;
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        const Vec2 centre(10 * x + random.between(-1, 1), 10 * y + random.between(-1, 1));
        world.push_back(convex(random, centre, random.between(1, 4), random.whole(3, 9)));
      }
    }
    const TravelResult result =
        travel(Method::kBug2,
               query_of(world, {random.between(-30, 30), -30}, {random.between(-30, 30), 30}));
    EXPECT_EQ(result.verdict, Verdict::kReached);
    EXPECT_LE(result.length, (result.bound->distance + result.bound->perimeters) * kSlack);
  }
}

TEST(Properties, TangentAndAceDecideLikeBug2AmongStandingObstacles) {
  TestRandom random(23);
  double tangent_sum = 0;
  double bug2_sum = 0;
  for (int i = 0; i < cases(2000); ++i) {
    SCOPED_TRACE(i);
    const TravelQuery query = i % 2 == 0 ? maze_query(random) : any_query(random, i / 2);
    TravelSettings settings;
    settings.most_length = 20'000;
    const TravelResult tangent = travel(Method::kTangent, query, settings);
    const TravelResult bug2 = travel(Method::kBug2, query);
    EXPECT_EQ(tangent.verdict, bug2.verdict) << told(tangent);
    if (bug2.verdict == Verdict::kReached) {
      tangent_sum += tangent.length;
      bug2_sum += bug2.length;
    }
    const TravelResult ace = travel(Method::kAce, query, settings);
    EXPECT_EQ(told(ace), told(tangent));
    EXPECT_EQ(ace.length, tangent.length);
  }
  RecordProperty("tangent_to_bug2", std::to_string(tangent_sum / bug2_sum));
}

TEST(Properties, TheLeftHandIsTheRightHandOfTheMirroredWorld) {
  TestRandom random(24);
  for (int i = 0; i < cases(40); ++i) {
    TravelQuery query = any_query(random, i);
    TravelSettings settings;
    settings.hand = Hand::kLeft;
    settings.most_length = 5000;
    for (const Method method : kMethods) {
      const TravelResult left = travel(method, query, settings);
      TravelQuery mirrored = query;
      for (Obstacle& obstacle : mirrored.obstacles) {
        for (Vec2& corner : obstacle.parts[0]) corner.y() = -corner.y();
      }
      mirrored.start.y() = -mirrored.start.y();
      mirrored.destination.y() = -mirrored.destination.y();
      TravelSettings right_settings = settings;
      right_settings.hand = Hand::kRight;
      const TravelResult right = travel(method, mirrored, right_settings);
      ASSERT_EQ(left.events.size(), right.events.size());
      EXPECT_EQ(left.length, right.length);
      for (std::size_t k = 0; k < left.events.size(); ++k) {
        EXPECT_EQ(left.events[k].point.y(), -right.events[k].point.y());
      }
    }
  }
}

TEST(Properties, TheLengthIsThatOfTheWay) {
  TestRandom random(25);
  for (int i = 0; i < cases(40); ++i) {
    const TravelQuery query = any_query(random, i);
    TravelSettings settings;
    settings.most_length = 5000;
    settings.speed = 2;
    for (const Method method : kMethods) {
      const TravelResult result = travel(method, query, settings);
      double length = 0;
      for (std::size_t k = 1; k < result.way.size(); ++k) {
        length += (result.way[k].point - result.way[k - 1].point).norm();
      }
      EXPECT_NEAR(result.length, length, 1e-9 * (1 + length));
      EXPECT_NEAR(result.time, length / 2, 1e-9 * (1 + length));
    }
  }
}

}  // namespace
}  // namespace rubicon::travel
