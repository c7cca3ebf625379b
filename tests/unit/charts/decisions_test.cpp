#include "src/fleets/charts/decisions.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace rubicon::charts {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(JudgeDistance, TellsWallsFromRobots) {
  EXPECT_EQ(judge_distance(10, 10), Judgement::kStatic);
  EXPECT_EQ(judge_distance(10, 10.04), Judgement::kStatic);
  EXPECT_EQ(judge_distance(10, 10.06), Judgement::kMovesAhead);
  EXPECT_EQ(judge_distance(10, 9.96), Judgement::kStatic);
  EXPECT_EQ(judge_distance(10, 9.9), Judgement::kComesNearer);
  EXPECT_EQ(judge_distance(10, 11, 2), Judgement::kStatic);
  EXPECT_EQ(name_of(Judgement::kMovesAhead), "moves_ahead");
  EXPECT_THROW(judge_distance(-1, 1), std::invalid_argument);
  EXPECT_THROW(judge_distance(1, kNan), std::invalid_argument);
  EXPECT_THROW(judge_distance(1, 1, -1), std::invalid_argument);
}

// The paper's travelway: 8 wide, lanes of 4, a robot of 2.
BypassResult round(double from, double to, double clearance = 0) {
  BypassQuery query;
  query.obstacle_from = from;
  query.obstacle_to = to;
  query.clearance = clearance;
  return choose_bypass(query);
}

TEST(ChooseBypass, GoesByTheMeasuredGaps) {
  EXPECT_EQ(round(2.5, 4).way, BypassWay::kRightInLane);  // Figure 6
  EXPECT_EQ(round(1, 3).way, BypassWay::kLeftLane);       // Figure 7
  EXPECT_EQ(round(1, 7).way, BypassWay::kReverse);        // Figure 8
  // 2.5 are free left of it in the own lane: the paper leaves the lane only for want of room.
  EXPECT_EQ(round(0, 1.5).way, BypassWay::kLeftInLane);
  EXPECT_EQ(round(0, 2.5).way, BypassWay::kLeftLane);
  EXPECT_EQ(name_of(BypassWay::kLeftLane), "left_lane");
}

TEST(ChooseBypass, AGapAsWideAsTheRobotWillDoUnlessItWantsClearance) {
  EXPECT_EQ(round(2, 4).way, BypassWay::kRightInLane);
  EXPECT_EQ(round(1.99, 4).way, BypassWay::kLeftLane);
  EXPECT_EQ(round(2, 4, 0.1).way, BypassWay::kLeftLane);
  EXPECT_EQ(round(0, 2).way, BypassWay::kLeftInLane);
  EXPECT_EQ(round(0, 2.01).way, BypassWay::kLeftLane);
  EXPECT_EQ(round(0, 6).way, BypassWay::kLeftLane);
  EXPECT_EQ(round(0, 6.01).way, BypassWay::kReverse);
  EXPECT_EQ(round(0, 6, 0.1).way, BypassWay::kReverse);
}

TEST(ChooseBypass, KeepsAsNearToTheMiddleOfTheLaneAsItCan) {
  EXPECT_EQ(round(2.5, 4).centre, 1.5);
  EXPECT_EQ(round(2.5, 4).gap, 2.5);
  EXPECT_EQ(round(2.5, 4, 0.25).centre, 1.25);
  EXPECT_EQ(round(3.5, 4).centre, 2);
  EXPECT_EQ(round(0, 0.5).centre, 2);
  EXPECT_EQ(round(0, 1.5).centre, 2.5);
  EXPECT_EQ(round(1, 3).centre, 6);
  EXPECT_EQ(round(1, 5.5).centre, 6.5);
  EXPECT_EQ(round(1, 5.5, 0.25).centre, 6.75);
  EXPECT_EQ(round(1, 7).gap, 0);
}

TEST(ChooseBypass, AnObstacleInTheLaneBesideLeavesTheOwnLaneFree) {
  const BypassResult result = round(5, 7);
  EXPECT_EQ(result.way, BypassWay::kRightInLane);
  EXPECT_EQ(result.gap, 4);
  EXPECT_EQ(result.centre, 2);
  EXPECT_EQ(round(-3, -1).way, BypassWay::kLeftInLane);
}

TEST(ChooseBypass, WithoutALaneBesideItGoesBack) {
  BypassQuery query;
  query.obstacle_from = 1;
  query.obstacle_to = 3;
  query.travelway_width = 4;
  EXPECT_EQ(choose_bypass(query).way, BypassWay::kReverse);
}

TEST(ChooseBypass, NeverTouchesObstacleOrWall) {
  for (double width = 0.5; width <= 4; width += 0.5) {
    for (double from = 0; from <= 8; from += 0.25) {
      for (double to = from; to <= 8; to += 0.25) {
        BypassQuery query;
        query.obstacle_from = from;
        query.obstacle_to = to;
        query.robot_width = width;
        query.clearance = 0.25;
        const BypassResult result = choose_bypass(query);
        const bool right = from >= width + 0.25;
        const bool left = 8 - to >= width + 0.25;
        EXPECT_EQ(result.way == BypassWay::kReverse, !(right && width + 0.25 <= 4) && !left);
        if (result.way == BypassWay::kReverse) continue;
        EXPECT_GE(result.centre - width / 2, 0);
        EXPECT_LE(result.centre + width / 2, result.way == BypassWay::kLeftLane ? 8 : 4);
        const bool is_right_of_it = result.centre + width / 2 <= from - 0.25;
        const bool is_left_of_it = result.centre - width / 2 >= to + 0.25;
        EXPECT_EQ(is_right_of_it, result.way == BypassWay::kRightInLane);
        EXPECT_EQ(is_left_of_it, result.way != BypassWay::kRightInLane);
      }
    }
  }
}

TEST(ChooseBypass, RefusesWhatCannotBe) {
  EXPECT_THROW(round(3, 2), std::invalid_argument);
  EXPECT_THROW(round(kNan, 2), std::invalid_argument);
  EXPECT_THROW(round(1, 2, -1), std::invalid_argument);
  BypassQuery query;
  query.robot_width = 0;
  EXPECT_THROW(choose_bypass(query), std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::charts
