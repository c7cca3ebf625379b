#include <gtest/gtest.h>

#include "src/motion/travel/travel.hpp"
#include "tests/unit/travel/fixtures.hpp"

namespace rubicon::travel {
namespace {

TravelResult pledge(const std::vector<Corners>& world, const Vec2& start, const Vec2& destination,
                    const Vec2& compass, Hand hand = Hand::kRight) {
  TravelSettings settings;
  settings.compass = compass;
  settings.hand = hand;
  settings.most_length = 2000;
  return travel(Method::kPledge, query_of(world, start, destination), settings);
}

TEST(Pledge, EscapesFromAU) {
  const TravelResult result = pledge({u_shape(-10, 0, 20, 20, 3)}, {0, 5}, {500, 0}, {0, 1});
  EXPECT_EQ(result.verdict, Verdict::kReached);
  EXPECT_EQ(told(result), "hit(0,17) clear(-10,0) escaped(-10,0)");
}

TEST(Pledge, EscapesFromACapitalG) {
  // The walker's old trap: whoever leaves at the first corner that looks north stays in it.
  const std::vector<Corners> g = {box(-10, 16, 20, 4), box(-10, -20, 4, 40), box(-10, -20, 20, 4),
                                  box(6, -20, 4, 22), box(-2, -2, 12, 4)};
  for (const Vec2& compass : {Vec2(0, 1), Vec2(0, -1), Vec2(1, 0), Vec2(-1, 0)}) {
    for (const Hand hand : {Hand::kRight, Hand::kLeft}) {
      const TravelResult result = pledge(g, {2, -9}, {500, 1}, compass, hand);
      EXPECT_EQ(result.verdict, Verdict::kReached) << told(result);
      EXPECT_EQ(result.events.back().kind, EventKind::kEscaped);
    }
  }
}

TEST(Pledge, InAClosedRingNeedsALimit) {
  const std::vector<Corners> ring = {box(-10, -10, 20, 2), box(-10, 8, 20, 2), box(-10, -10, 2, 20),
                                     box(8, -10, 2, 20)};
  const TravelResult result = pledge(ring, {0, 0}, {500, 0}, {0, 1});
  EXPECT_EQ(result.verdict, Verdict::kLimit);
  EXPECT_GE(result.length, 2000);
}

TEST(Pledge, EndsAtADestinationOnItsWay) {
  const TravelResult result = pledge({box(-10, 0, 20, 10)}, {0, -20}, {-10, 30}, {0, 1});
  EXPECT_EQ(result.verdict, Verdict::kReached);
  EXPECT_EQ(told(result), "hit(0,0) clear(-10,0) reached(-10,30)");
}

TEST(Pledge, EscapesFromMazesWithAnExit) {
  TestRandom random(71);
  for (int i = 0; i < cases(200); ++i) {
    const auto walls = wall_maze(random, 6, 4, random.between(0.2, 0.55));
    const Vec2 start(random.whole(0, 5) * 4 + 2, random.whole(0, 5) * 4 + 2);
    // Whoever can go to a place far away can get out.
    const bool exit =
        travel(Method::kBug2, query_of(walls, start, {100.5, 77.25})).verdict == Verdict::kReached;
    const TravelResult result = pledge(walls, start, {-1000, 3}, {0.25, 1});
    EXPECT_EQ(result.verdict == Verdict::kReached, exit) << told(result).substr(0, 300);
  }
}

}  // namespace
}  // namespace rubicon::travel
