#include <gtest/gtest.h>

#include <tuple>

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

TEST(Bugs, APointInWhichObstaclesMeetIsLeftOnItsOtherSide) {
  // The line is closed in (3, 4) and open on the other side of it, which is no nearer.
  const std::vector<Corners> boxes{box(2, 4, 1, 1), box(3, 3, 1, 1)};
  EXPECT_EQ(told(run(Method::kBug2, boxes, {4, 5}, {2, 3})), "hit(3,4) leave(3,4) reached(2,3)");
  // Of two needles their common tip is the nearest point of all.
  const std::vector<Corners> needles{{{0, 0}, {-8, -4}, {-8, -5}}, {{0, 0}, {8, -5}, {8, -4}}};
  for (const auto& [world, start, destination] :
       {std::tuple(boxes, Vec2(4, 5), Vec2(2, 3)), std::tuple(needles, Vec2(0, -6), Vec2(0, 6))}) {
    for (const Method method :
         {Method::kBug1, Method::kBug2, Method::kVisBug21, Method::kTangent, Method::kAce}) {
      const TravelResult result = run(method, world, start, destination);
      EXPECT_EQ(result.verdict, Verdict::kReached) << name_of(method) << " " << told(result);
      if (result.bound) {
        EXPECT_LE(result.length, result.bound->length);
      }
    }
  }
}

/// Cells of a grid that are filled or not, of which many touch in corners; from cell to cell, the
/// line often passes these.
TEST(Bugs, DecideAlikeAmongCellsThatTouchInCorners) {
  TestRandom random(45);
  int pinches = 0;
  for (int i = 0; i < cases(300); ++i) {
    SCOPED_TRACE(i);
    constexpr int kCells = 7;
    std::vector<Vec2> free;
    std::vector<Corners> world;
    for (int k = 0; k < kCells * kCells; ++k) {
      const Vec2 cell(k % kCells, k / kCells);  // NOLINT: whole
      if (random.whole(0, 99) < 45) {
        world.push_back(box(cell.x(), cell.y(), 1, 1));
      } else {
        free.push_back(cell + Vec2(0.5, 0.5));
      }
    }
    const auto any = [&] { return free[static_cast<std::size_t>(random.bits() % free.size())]; };
    const TravelQuery query = query_of(world, any(), any());
    const TravelResult bug1 = travel(Method::kBug1, query);
    const TravelResult bug2 = travel(Method::kBug2, query);
    for (const TravelResult& each :
         {bug2, travel(Method::kVisBug21, query), travel(Method::kTangent, query)}) {
      EXPECT_EQ(each.verdict, bug1.verdict) << told(bug1) << " | " << told(each);
    }
    if (bug1.bound) {
      EXPECT_LE(bug1.length, bug1.bound->length + 1e-9);
      EXPECT_LE(bug2.length, bug2.bound->length + 1e-9);
    }
    for (std::size_t k = 1; k < bug2.events.size(); ++k) {
      pinches += bug2.events[k].kind == EventKind::kLeave &&
                         bug2.events[k].point == bug2.events[k - 1].point
                     ? 1
                     : 0;
    }
  }
  EXPECT_GT(pinches, 0);
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
