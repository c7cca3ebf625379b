#include "src/fleets/charts/avoidance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/charts/chart_fixtures.hpp"

namespace rubicon::charts {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Avoidance : public testing::Test {
 protected:
  // Arrival in s at nodes, 10 s of driving from one to the next.
  static Chart chart(const std::vector<std::pair<NodeIndex, int>>& arrivals) {
    Chart result;
    for (const auto& [node, seconds] : arrivals) {
      result.stops.push_back({node, seconds * kSecond, kNone, Leg::kAlong, 10 * kSecond});
    }
    return result;
  }

  void add(int priority, int start, const std::vector<std::pair<NodeIndex, int>>& arrivals) {
    Robot robot;
    robot.name = "R" + std::to_string(robots_.size() + 1);
    robot.priority = priority;
    robot.start = start * kSecond;
    robots_.push_back(robot);
    charts_.push_back(chart(arrivals));
  }

  std::vector<int> seconds(std::size_t robot) const {
    std::vector<int> result;
    for (const Stop& stop : charts_[robot].stops) {
      result.push_back(static_cast<int>(stop.arrival / kSecond));
    }
    return result;
  }

  bool avoid() { return avoid_conflicts(robots_, charts_, settings_, records_); }

  std::vector<Robot> robots_;
  std::vector<Chart> charts_;
  AvoidanceSettings settings_;
  std::vector<Record> records_;
};

TEST_F(Avoidance, TheLowerPriorityIsDelayedFromTheNodeOn) {
  add(1, 0, {{1, 0}, {2, 10}, {3, 20}});
  add(2, 5, {{4, 5}, {2, 12}, {5, 22}});
  EXPECT_TRUE(avoid());
  EXPECT_THAT(seconds(0), ElementsAre(0, 20, 30));  // 15 is still less than 5 s from 12
  EXPECT_THAT(seconds(1), ElementsAre(5, 12, 22));
  ASSERT_EQ(records_.size(), 2U);
  EXPECT_EQ(records_[0].robot, 0);
  EXPECT_EQ(records_[0].other, 1);
  EXPECT_EQ(records_[0].node, 2);
  EXPECT_EQ(records_[0].time, 10 * kSecond);
  EXPECT_EQ(records_[0].stop, 1);
  EXPECT_EQ(records_[0].before, 10 * kSecond);
  EXPECT_EQ(records_[0].after, 15 * kSecond);
  EXPECT_EQ(records_[0].conflict, Conflict::kNode);
}

TEST_F(Avoidance, OfEqualPrioritiesTheLaterStartIsDelayedThenTheLaterRobot) {
  add(1, 3, {{1, 3}, {2, 10}});
  add(1, 0, {{3, 0}, {2, 10}});
  EXPECT_TRUE(avoid());
  EXPECT_THAT(seconds(0), ElementsAre(3, 15));
  EXPECT_THAT(seconds(1), ElementsAre(0, 10));
  robots_.clear();
  charts_.clear();
  add(1, 0, {{1, 0}, {2, 10}});
  add(1, 0, {{3, 0}, {2, 10}});
  EXPECT_TRUE(avoid());
  EXPECT_THAT(seconds(0), ElementsAre(0, 10));
  EXPECT_THAT(seconds(1), ElementsAre(0, 15));
}

TEST_F(Avoidance, ATouchOfTheToleranceIsNoConflict) {
  add(1, 0, {{2, 10}});
  add(2, 0, {{2, 15}});
  EXPECT_TRUE(avoid());
  EXPECT_THAT(records_, IsEmpty());
  charts_[1].stops[0].arrival -= 1;
  EXPECT_TRUE(avoid());
  EXPECT_EQ(records_.size(), 2U);
}

TEST_F(Avoidance, ConflictsThatADelayMakesAreResolvedToo) {
  add(3, 0, {{1, 0}, {2, 10}});
  add(2, 0, {{3, 0}, {2, 16}, {4, 26}});
  add(1, 0, {{5, 0}, {2, 12}, {4, 24}});
  EXPECT_TRUE(avoid());
  EXPECT_THAT(seconds(0), ElementsAre(0, 10));
  EXPECT_THAT(seconds(1), ElementsAre(0, 16, 26));
  EXPECT_THAT(seconds(2), ElementsAre(0, 22, 34));
}

TEST_F(Avoidance, ThePresentPlaceIsNoNodeToMeetAt) {
  add(1, 0, {{kNone, 35}, {2, 50}});
  add(2, 0, {{kNone, 35}, {3, 50}});
  EXPECT_TRUE(avoid());
  EXPECT_THAT(records_, IsEmpty());
}

TEST_F(Avoidance, GivesUpWhereItsLimitIsReached) {
  add(1, 0, {{2, 10}});
  add(2, 0, {{2, 10}});
  settings_.delay = 1;
  settings_.most_moves = 1000;
  EXPECT_FALSE(avoid());
  EXPECT_EQ(records_.size(), 1000U);
  settings_.delay = kSecond;
  EXPECT_TRUE(avoid());
}

TEST_F(Avoidance, RefusesSettingsThatMakeNoSense) {
  add(1, 0, {{2, 10}});
  settings_.tolerance = -1;
  EXPECT_THROW(avoid(), std::invalid_argument);
  settings_ = {};
  settings_.delay = 0;
  EXPECT_THROW(avoid(), std::invalid_argument);
  settings_ = {};
  settings_.clearance = 0;
  EXPECT_THROW(avoid(), std::invalid_argument);
  settings_ = {};
  charts_.clear();
  EXPECT_THROW(avoid(), std::invalid_argument);
}

TEST_F(Avoidance, RightOfWayIsByPriorityThenStart) {
  add(1, 0, {{1, 0}});
  add(3, 9, {{2, 9}});
  add(3, 4, {{3, 4}});
  add(2, 0, {{4, 0}});
  EXPECT_THAT(right_of_way(robots_, charts_), ElementsAre(2, 1, 3, 0));
}

TEST_F(Avoidance, WhoIsInTheBorrowedLaneGoesBeforeTheOneThatBorrowsIt) {
  const LaneIndex own = 7;
  const LaneIndex borrowed = 8;
  add(1, 0, {{kNone, 35}, {2, 50}});  // in the borrowed lane
  charts_[0].stops[0].lane = charts_[0].stops[1].lane = borrowed;
  add(3, 0, {{kNone, 35}, {4, 60}, {5, 80}});  // borrows it
  charts_[1].stops[0].lane = own;
  charts_[1].stops[1].lane = borrowed;
  charts_[1].stops[1].leg = Leg::kAgainst;
  add(2, 0, {{6, 0}});
  EXPECT_THAT(right_of_way(robots_, charts_), ElementsAre(0, 1, 2));
  EXPECT_TRUE(avoid());
  EXPECT_THAT(seconds(0), ElementsAre(35, 50));
  EXPECT_THAT(seconds(1), ElementsAre(55, 80, 100));
  // Once it is out of its lane it goes before all.
  charts_[1].stops[0].leg = Leg::kAgainst;
  charts_[0] = chart({{9, 0}});
  EXPECT_THAT(right_of_way(robots_, charts_), ElementsAre(1, 2, 0));
}

TEST_F(Avoidance, WhoBypassesWaitsInItsOwnLane) {
  add(1, 0, {{kNone, 35}, {4, 60}, {5, 80}});
  charts_[0].stops[0].lane = 7;
  charts_[0].stops[1].lane = 8;
  charts_[0].stops[2].lane = 9;
  charts_[0].stops[1].leg = charts_[0].stops[2].leg = Leg::kAgainst;
  add(2, 0, {{6, 0}, {5, 81}});
  EXPECT_TRUE(avoid());
  EXPECT_THAT(seconds(0), ElementsAre(45, 70, 90));
}

TEST_F(Avoidance, AHigherPriorityOnTheWayAcrossIsLetThrough) {
  const LaneIndex across = 9;
  add(1, 0, {{kNone, 35}, {4, 60}, {5, 80}});
  charts_[0].stops[0].lane = 7;
  charts_[0].stops[1].lane = 8;
  charts_[0].stops[1].leg = Leg::kAgainst;
  charts_[0].stops[2].lane = across;
  charts_[0].stops[2].leg = Leg::kAgainst;
  add(2, 0, {{6, 40}, {5, 55}, {4, 70}});
  charts_[1].stops[2].lane = across;
  EXPECT_TRUE(avoid());
  EXPECT_THAT(seconds(1), ElementsAre(40, 55, 70));
  EXPECT_THAT(seconds(0), ElementsAre(50, 75, 95));  // at the bypass node 5 s after the other
  EXPECT_EQ(records_.at(0).conflict, Conflict::kAcross);
}

TEST_F(Avoidance, TheWayAcrossIsLookedAtFirst) {
  const LaneIndex borrowed = 8;
  const LaneIndex across = 9;
  add(2, 0, {{kNone, 35}, {4, 60}, {5, 80}});
  charts_[0].stops[0].lane = 7;
  charts_[0].stops[1].lane = borrowed;
  charts_[0].stops[2].lane = across;
  charts_[0].stops[1].leg = charts_[0].stops[2].leg = Leg::kAgainst;
  // It would meet the other one on both.
  add(1, 0, {{6, 20}, {5, 50}, {4, 60}, {3, 90}});
  charts_[1].stops[2].lane = across;
  charts_[1].stops[3].lane = borrowed;
  settings_.tolerance = 0;
  EXPECT_TRUE(avoid());
  ASSERT_EQ(records_.size(), 1U);
  EXPECT_EQ(records_[0].conflict, Conflict::kAcross);
  EXPECT_THAT(seconds(1), ElementsAre(20, 85, 95, 125));
}

TEST_F(Avoidance, WhoIsAheadInALaneIsNotInTheWayOfOneThatGoesBack) {
  add(1, 0, {{kNone, 35}, {2, 50}});
  charts_[0].stops[0].lane = charts_[0].stops[1].lane = 7;
  add(3, 0, {{kNone, 35}, {4, 60}});  // goes back in the same lane, behind the other
  charts_[1].stops[0].lane = charts_[1].stops[1].lane = 7;
  charts_[1].stops[1].leg = Leg::kAgainst;
  EXPECT_THAT(right_of_way(robots_, charts_), ElementsAre(1, 0));
  EXPECT_TRUE(avoid());
  EXPECT_THAT(records_, IsEmpty());
}

TEST_F(Avoidance, TwoThatAreOutOfTheirLanesLetEachOtherThrough) {
  // The first is in the lane beside and will cross to node 5; the second comes back to node 5 from
  // lane 6, and then goes where the first one crosses. The first then wants to enter lane 6.
  const LaneIndex across = 9;
  add(2, 0, {{kNone, 35}, {4, 45}, {5, 65}, {3, 85}});
  charts_[0].stops[0].lane = charts_[0].stops[1].lane = 8;
  charts_[0].stops[0].leg = charts_[0].stops[1].leg = charts_[0].stops[2].leg = Leg::kAgainst;
  charts_[0].stops[2].lane = across;
  charts_[0].stops[3].lane = 6;
  add(1, 0, {{kNone, 35}, {5, 40}, {4, 60}});
  charts_[1].stops[0].lane = charts_[1].stops[1].lane = 6;
  charts_[1].stops[0].leg = charts_[1].stops[1].leg = Leg::kAgainst;
  charts_[1].stops[2].lane = across;
  EXPECT_TRUE(avoid());
  EXPECT_THAT(seconds(0), ElementsAre(35, 45, 65, 85));
  EXPECT_THAT(seconds(1), ElementsAre(35, 40, 80));  // leaves node 5 at 70
}

TEST_F(Avoidance, WhoCannotWaitIsNotAskedTo) {
  // Both are out of their lanes, but the first one until node 4, and the second only until node 6.
  add(1, 0, {{kNone, 35}, {4, 45}});
  charts_[0].stops[0].leg = charts_[0].stops[1].leg = Leg::kAgainst;
  charts_[0].stops[0].lane = charts_[0].stops[1].lane = 7;
  add(3, 0, {{kNone, 35}, {6, 38}, {4, 48}});
  charts_[1].stops[0].leg = charts_[1].stops[1].leg = Leg::kAgainst;
  charts_[1].stops[0].lane = charts_[1].stops[1].lane = 8;
  EXPECT_TRUE(avoid());
  EXPECT_THAT(seconds(0), ElementsAre(35, 45));
  EXPECT_THAT(seconds(1), ElementsAre(35, 38, 53));
}

TEST_F(Avoidance, WhoTurnsRoundAtANodeWaitsForThoseThatStillComeBack) {
  const LaneIndex lane = 7;
  // Back at node 4 at 45, and into the lane again; it has right of way, yet it is the one to wait.
  add(3, 0, {{kNone, 35}, {4, 45}, {5, 75}});
  add(1, 0, {{kNone, 35}, {4, 60}});
  for (Chart& one : charts_) {
    one.stops[0].lane = one.stops[1].lane = lane;
    one.stops[1].leg = Leg::kAgainst;
  }
  charts_[0].stops[2].lane = lane;
  charts_[0].stops[2].travel = 30 * kSecond;
  EXPECT_TRUE(avoid());
  EXPECT_THAT(seconds(0), ElementsAre(35, 45, 95));
  EXPECT_THAT(seconds(1), ElementsAre(35, 60));
}

}  // namespace
}  // namespace rubicon::charts
