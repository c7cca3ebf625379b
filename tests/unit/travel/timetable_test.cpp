#include "src/motion/travel/timetable.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/unit/travel/fixtures.hpp"

namespace rubicon::travel {
namespace {

Obstacle shuttle() {
  Obstacle obstacle = standing("gate", box(-1, -1, 2, 2));
  obstacle.timetable = {{10, {0, 0}, 0}, {20, {10, 0}, 0}, {25, {10, 0}, 0}, {35, {0, 0}, 0}};
  obstacle.repeat = true;
  return obstacle;
}

TEST(Timetable, RunsAndRepeats) {
  const Obstacle gate = shuttle();
  EXPECT_EQ(placement_at(gate, 0).place.x(), 0);
  EXPECT_DOUBLE_EQ(placement_at(gate, 12).place.x(), 2);
  EXPECT_EQ(placement_at(gate, 22).place.x(), 10);
  EXPECT_DOUBLE_EQ(placement_at(gate, 30).place.x(), 5);
  EXPECT_DOUBLE_EQ(placement_at(gate, 25 * 4 + 12).place.x(), 2);
}

TEST(Timetable, KnowsWhenSomethingMovesNext) {
  MovingOutline world({shuttle()});
  EXPECT_EQ(world.next_motion(0), 10);
  EXPECT_EQ(world.next_motion(12), 12);
  EXPECT_EQ(world.next_motion(20), 25);
  EXPECT_EQ(world.next_motion(35), 35);
  MovingOutline still({standing("s", box(0, 0, 1, 1))});
  EXPECT_TRUE(std::isinf(still.next_motion(0)));
}

TEST(Timetable, TurnsTheShortWay) {
  Obstacle arm = standing("arm", box(0, -1, 10, 2));
  arm.timetable = {{0, {5, 5}, 350}, {10, {5, 5}, 20}};
  EXPECT_DOUBLE_EQ(placement_at(arm, 5).heading_deg, 365);
  MovingOutline world({arm});
  world.move_to(10.0 / 3);
  // At 0 degrees: from (5, 4) to (15, 6).
  EXPECT_NEAR(world.outline().composites()[0].loops[0].length, 24, 1e-5);
  EXPECT_EQ(world.outline().place_of(nearby({14.9, 5.9})), 1);
  EXPECT_TRUE(world.moved(0));
}

TEST(Timetable, RefusesWhatCannotBeDriven) {
  Obstacle gate = shuttle();
  gate.timetable[1].time = 10;
  EXPECT_THROW(MovingOutline({gate}), std::invalid_argument);
  gate = shuttle();
  gate.timetable[3].place = {1, 0};
  EXPECT_THROW(MovingOutline({gate}), std::invalid_argument);
  gate = shuttle();
  gate.timetable[1].heading_deg = 180;
  EXPECT_THROW(MovingOutline({gate}), std::invalid_argument);
}

TravelResult ace(std::vector<Obstacle> obstacles, const Vec2& start, const Vec2& destination) {
  TravelSettings settings;
  settings.most_time = 1000;
  return travel(Method::kAce, {std::move(obstacles), start, destination}, settings);
}

TEST(Walker, IsPushedFromBehindAndGoesOn) {
  // Faster than the robot and behind it: it is pushed along, which is no event.
  const TravelResult result =
      ace({moving("M", box(-5, -10, 10, 6), 0, 10, {0, 2})}, {0, -3}, {0, 40});
  EXPECT_EQ(result.verdict, Verdict::kReached);
  EXPECT_EQ(told(result), "reached(0,40)");
  EXPECT_LT(result.time, 40);
}

TEST(Walker, IsStruckFromTheSideAndFollows) {
  const TravelResult result =
      ace({moving("M", box(-20, -3, 10, 6), 5, 15, {2, 0})}, {0, -10}, {0, 40});
  EXPECT_EQ(result.verdict, Verdict::kReached);
  ASSERT_GE(result.events.size(), 2u);
  EXPECT_EQ(result.events[0].kind, EventKind::kHit);
  EXPECT_EQ(result.events[0].obstacles, std::vector<std::string>{"M"});
  EXPECT_EQ(result.events[1].kind, EventKind::kClear);
}

TEST(Walker, ThinAndFastObstaclesDoNotJumpOverIt) {
  for (const double slice : {0.25, 1.0, 5.0}) {
    TravelSettings settings;
    settings.slice = slice;
    const TravelResult result =
        travel(Method::kAce,
               {{moving("M", box(-30, 10, 60, 0.1), 0, 20, {0, -2})}, {0, -10}, {0, 40}}, settings);
    EXPECT_EQ(result.verdict, Verdict::kReached);
    EXPECT_GE(result.events.size(), 3u) << told(result);
  }
  EXPECT_DOUBLE_EQ(thickness(ring_of(box(0, 0, 60, 0.5))), 0.5);
  EXPECT_DOUBLE_EQ(thickness(ring_of(u_shape(0, 0, 20, 20, 3))), 3);
}

TEST(Walker, IsCarriedByWhatItFollows) {
  // The robot follows the south side of a box that drives north while it does so.
  const TravelResult result =
      ace({moving("M", box(-20, 0, 40, 4), 15, 25, {0, 1})}, {0, -10}, {0, 60});
  EXPECT_EQ(result.verdict, Verdict::kReached);
  EXPECT_EQ(result.events.front().kind, EventKind::kHit);
  // 10 m to the box, 20 m along its side, 10 m carried, 4 m on, then straight.
  EXPECT_NEAR(result.length, 10 + 20 + 10 + 4 + std::sqrt(400.0 + 46 * 46), 0.5);
  EXPECT_NEAR(result.time, result.length - 10, 0.5);
}

TEST(Walker, IsSqueezedBetweenTwo) {
  // A box closes the gap in which the robot follows the other one.
  const TravelResult result =
      ace({standing("S", box(-20, 0, 40, 4)), moving("M", box(-30, -12, 60, 4), 12, 24, {0, 1})},
          {0, -4}, {0, 60});
  bool squeezed = false;
  for (const Event& event : result.events) squeezed |= event.kind == EventKind::kSqueezed;
  EXPECT_TRUE(squeezed) << told(result);
  EXPECT_EQ(result.verdict, Verdict::kReached) << told(result);
}

TEST(Walker, AnObstacleOnTheStartCoversIt) {
  const TravelResult result = ace({standing("S", box(-5, -5, 10, 10))}, {0, 0}, {0, 60});
  EXPECT_EQ(result.verdict, Verdict::kUnreachable);
  EXPECT_EQ(told(result), "covered(0,0)");
}

TEST(Walker, SettingsThatAreNotPositiveAreRefused) {
  TravelSettings settings;
  settings.speed = 0;
  EXPECT_THROW(travel(Method::kBug2, figure_1(), settings), std::invalid_argument);
  settings = {};
  settings.vision = 0;
  EXPECT_THROW(travel(Method::kVisBug21, figure_4c(false), settings), std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::travel
