#include <gtest/gtest.h>

#include "src/motion/travel/travel.hpp"
#include "tests/unit/travel/travel_worlds.hpp"

namespace rubicon::travel {
namespace {

TravelResult run(Method method, const std::vector<Corners>& world, const Vec2& start,
                 const Vec2& destination, const TravelSettings& settings = {}) {
  return travel(method, query_of(world, start, destination), settings);
}

TEST(Bug2, GoesRoundABox) {
  const TravelResult result = run(Method::kBug2, {box(-10, 0, 20, 10)}, {0, -20}, {0, 30});
  EXPECT_EQ(result.verdict, Verdict::kReached);
  EXPECT_DOUBLE_EQ(result.length, 70);
  EXPECT_EQ(told(result), "hit(0,0) leave(0,10) reached(0,30)");
}

TEST(Bug1, GoesRoundABoxAndBackTheShorterWay) {
  const TravelResult result = run(Method::kBug1, {box(-10, 0, 20, 10)}, {0, -20}, {0, 30});
  EXPECT_EQ(result.verdict, Verdict::kReached);
  EXPECT_DOUBLE_EQ(result.length, 130);
  EXPECT_EQ(told(result), "hit(0,0) nearest(0,10) reached(0,30)");
}

TEST(Bug2, LeavesAU) {
  const auto u = u_shape(-10, 0, 20, 20, 3);
  const TravelResult result = run(Method::kBug2, {u}, {0, -30}, {0, 40});
  EXPECT_EQ(result.verdict, Verdict::kReached);
  EXPECT_DOUBLE_EQ(result.length, 124);
}

TEST(Bugs, TheExampleOfTheDocumentation) {
  TravelQuery query{{{"box", {{{-10, 0}, {10, 0}, {10, 10}, {-10, 10}}}, {}}}, {0, -20}, {0, 30}};
  const TravelResult result = travel(Method::kBug2, query);
  EXPECT_EQ(told(result), "hit(0,0) leave(0,10) reached(0,30)");
  EXPECT_EQ(result.events[0].obstacles, std::vector<std::string>{"box"});
  EXPECT_DOUBLE_EQ(result.bound->length, 50 + 60);
  EXPECT_EQ(result.bound->crossings, 2);
}

TEST(Bugs, WhereNothingStandsTheWayIsStraight) {
  for (const Method method : kMethods) {
    const TravelResult straight = run(method, {}, {1, 2}, {31, 42});
    EXPECT_EQ(straight.verdict, Verdict::kReached) << name_of(method);
    EXPECT_NEAR(straight.length, 50, 1e-9) << name_of(method);
    const TravelResult none = run(method, {}, {1, 2}, {1, 2});
    EXPECT_EQ(none.verdict, Verdict::kReached) << name_of(method);
    EXPECT_EQ(none.length, 0) << name_of(method);
  }
}

TEST(Bugs, ADestinationInABoxIsUnreachable) {
  for (const Method method : {Method::kBug1, Method::kBug2, Method::kTangent, Method::kAce}) {
    const TravelResult result = run(method, {box(-10, 0, 20, 10)}, {0, -40}, {0, 5});
    EXPECT_EQ(result.verdict, Verdict::kUnreachable) << name_of(method);
    if (method == Method::kBug2) {
      EXPECT_DOUBLE_EQ(result.length, 100);
    }
  }
}

}  // namespace
}  // namespace rubicon::travel
