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
