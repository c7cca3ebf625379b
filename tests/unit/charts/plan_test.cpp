#include "src/fleets/charts/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "src/fleets/lanes/grid.hpp"
#include "tests/unit/charts/chart_fixtures.hpp"

namespace rubicon::charts {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Planning : public testing::Test {
 protected:
  Robot one(const std::string& name, int priority, int start, const std::string& from,
            const std::string& goal) const {
    return robot(network_, name, priority, start, from, goal);
  }
  LaneReport seen(RobotIndex robot, const std::string& from, const std::string& to,
                  int time) const {
    return {robot, lane(network_, from, to), time * kSecond};
  }
  BypassReport met(RobotIndex robot, const std::string& from, const std::string& to, int time,
                   double share, BypassWay way) const {
    const LaneIndex its_lane = lane(network_, from, to);
    return {robot, its_lane, time * kSecond, share * network_.length(its_lane), way};
  }
  std::string chart(const Plan& plan, std::size_t robot = 0) const {
    return told(network_, plan.charts[robot]);
  }

  LaneNetwork network_{lanes::warehouse()};
};

TEST_F(Planning, SixRobotsFromOneNodeEndWithoutAConflict) {
  std::vector<Robot> robots;
  const char* goals[] = {"B5", "B7", "A5", "C5", "B10", "A9"};
  for (int i = 0; i < 6; ++i) {
    robots.push_back(one("R" + std::to_string(i + 1), i % 2, i < 4 ? 0 : 3, "A", goals[i]));
  }
  const Plan plan = make_plan(network_, robots);
  EXPECT_TRUE(plan.settled);
  EXPECT_THAT(plan.records, Not(IsEmpty()));
  for (std::size_t a = 0; a < 6; ++a) {
    EXPECT_EQ(plan.charts[a].stops.back().node, plan.robots[a].goal);
    for (std::size_t b = 0; b < a; ++b) {
      for (const Stop& one_stop : plan.charts[a].stops) {
        for (const Stop& other : plan.charts[b].stops) {
          if (one_stop.node != other.node) continue;
          EXPECT_GE(std::abs(one_stop.arrival - other.arrival), 5 * kSecond);
        }
      }
    }
  }
}

TEST_F(Planning, KnownObstaclesAreAvoidedFromTheStart) {
  const std::vector<LaneIndex> closed = {lane(network_, "B3", "B3B5")};
  const Plan plan = make_plan(network_, {one("R", 1, 0, "A", "B5")}, {}, closed);
  EXPECT_EQ(chart(plan), "A 0, A1 30, A1A3 70, A3 90, A3A5 130, A5 150, B6B8 170, B5 190");
}

TEST_F(Planning, CriteriaOfTheSettingsCount) {
  PlanSettings settings;
  settings.criterion = lanes::Criterion::kDistance;
  EXPECT_EQ(chart(make_plan(network_, {one("R", 1, 0, "A", "A2")})), "A 0, AA 75, A2 105");
  EXPECT_THAT(chart(make_plan(network_, {one("R", 1, 0, "A", "A2")}, settings)),
              HasSubstr("A9A11 310, A2 330"));
}

TEST_F(Planning, ABlockedLaneIsAvoidedByAll) {
  const Plan plan = make_plan(network_, {one("R1", 1, 0, "B1", "B5"), one("R2", 1, 40, "B1", "B5"),
                                         one("R3", 1, 0, "A", "A5")});
  EXPECT_EQ(chart(plan, 0), "B1 0, B1B3 40, B3 60, B3B5 100, B5 120");
  // R1 stands at B3.
  const Plan after = lane_blocked(network_, plan, seen(0, "B3", "B3B5", 60));
  EXPECT_THAT(
      told(network_, after),
      ElementsAre("R1 sees at 60 s that B3 to B3B5 is blocked", "B3 to B3B5 is closed to all",
                  "R1 has a new way from B3", "R2 has a new way from B1B3"));
  EXPECT_EQ(chart(after, 0), "Cur-Pos 60, C8C10 80, C3 100, C3C5 140, C8 160, B3B5 180, B5 200");
  EXPECT_THAT(chart(after, 1), Not(HasSubstr("B3B5 120")));
  EXPECT_EQ(chart(after, 2), told(network_, chart_at(plan.charts[2], 60 * kSecond)));
  EXPECT_EQ(after.closed, (std::vector<LaneIndex>{lane(network_, "B3", "B3B5")}));
  // A second report changes nothing but that it was seen.
  const Plan again = lane_blocked(network_, after, seen(2, "B3", "B3B5", 60));
  EXPECT_EQ(again.records.size(), 1U);
  EXPECT_EQ(told(network_, again.charts), told(network_, after.charts));
}

TEST_F(Planning, WhoIsOnItsWayToTheNodePlansAgainFromThere) {
  const Plan plan = make_plan(network_, {one("R1", 1, 0, "B1", "B5")});
  const Plan after = lane_blocked(network_, plan, seen(0, "B3", "B3B5", 50));
  EXPECT_EQ(chart(after),
            "Cur-Pos 50, B3 60, C8C10 80, C3 100, C3C5 140, C8 160, B3B5 180, B5 200");
}

TEST_F(Planning, AReopenedLaneIsTakenWhereItIsBetter) {
  const Plan plan = make_plan(network_, {one("R1", 1, 0, "B1", "B5")});
  const Plan blocked = lane_blocked(network_, plan, seen(0, "B3", "B3B5", 50));
  const Plan open = lane_free(network_, blocked, seen(0, "B3", "B3B5", 55));
  EXPECT_EQ(chart(open), "Cur-Pos 55, B3 60, B3B5 100, B5 120");
  EXPECT_THAT(told(network_, open),
              ElementsAre("B3 to B3B5 is open again", "R1 has a new way from B3"));
  EXPECT_THAT(open.closed, IsEmpty());
  // From C3C5 on the detour is the better way.
  const Plan late = lane_free(network_, blocked, seen(0, "B3", "B3B5", 130));
  EXPECT_EQ(chart(late), "Cur-Pos 130, C3C5 140, C8 160, B3B5 180, B5 200");
  EXPECT_THAT(told(network_, late), ElementsAre("B3 to B3B5 is open again"));
  EXPECT_THAT(lane_free(network_, plan, seen(0, "B3", "B3B5", 50)).records, IsEmpty());
}

TEST(PlanningOnALine, WithoutAWayARobotReturnsAndTriesAgainWhenTheLaneIsFree) {
  const LaneNetwork network(lanes::grid({4, 1, 10}));
  const Plan plan = make_plan(network, {robot(network, "R1", 1, 0, "x0y0", "x3y0")});
  const LaneIndex last = lane(network, "x2y0", "x3y0");
  const Plan blocked = lane_blocked(network, plan, {0, last, 15 * kSecond});
  EXPECT_EQ(told(network, blocked.charts[0]), "Cur-Pos 15, x2y0 20, x1y0 30, x0y0 40");
  EXPECT_EQ(blocked.errands[0], Errand::kBack);
  EXPECT_THAT(told(network, blocked),
              Contains("R1 finds no way from x2y0 to its goal and returns to its start"));
  const Plan open = lane_free(network, blocked, {0, last, 28 * kSecond});
  EXPECT_EQ(told(network, open.charts[0]), "Cur-Pos 28, x1y0 30, x2y0 40, x3y0 50");
  EXPECT_EQ(open.errands[0], Errand::kToGoal);
  // And from its start, long after it is back there.
  const Plan later = lane_free(network, blocked, {0, last, 100 * kSecond});
  EXPECT_EQ(told(network, later.charts[0]), "Cur-Pos 100, x1y0 110, x2y0 120, x3y0 130");
}

TEST(PlanningOnALine, WithoutAWayBackItIsStranded) {
  const LaneNetwork network(
      {{{"lane", 1, 4, 1}}, {{"a", 0, 0}, {"b", 10, 0}, {"c", 20, 0}}, {{0, 1}, {1, 2}}});
  const Plan plan = make_plan(network, {robot(network, "R1", 1, 0, "a", "c")});
  const Plan blocked = lane_blocked(network, plan, {0, 1, 5 * kSecond});
  EXPECT_EQ(told(network, blocked.charts[0]), "Cur-Pos 5, b 10");
  EXPECT_EQ(blocked.errands[0], Errand::kStranded);
  EXPECT_THAT(told(network, blocked), Contains("R1 finds no way from b to its goal or back"));
  const Plan none = make_plan(network, {robot(network, "R1", 1, 0, "c", "a")});
  EXPECT_EQ(none.errands[0], Errand::kStranded);
  EXPECT_EQ(told(network, none.charts[0]), "c 0");
  ASSERT_EQ(none.records.size(), 1U);
  EXPECT_EQ(name_of(none.records[0].kind), "stranded");
  // A robot that is where it wants to be has nothing to plan.
  EXPECT_EQ(make_plan(network, {robot(network, "R1", 1, 0, "c", "c")}).errands[0], Errand::kToGoal);
}

TEST(PlanningOnALine, ABypassWhereLanesShareTheirNodesHasNoWayAcross) {
  const LaneNetwork network(lanes::grid({3, 1, 10}));
  const Plan plan = make_plan(network, {robot(network, "R1", 1, 10, "x0y0", "x2y0"),
                                        robot(network, "R2", 2, 0, "x2y0", "x0y0")});
  const Plan after = bypass(
      network, plan, {0, lane(network, "x0y0", "x1y0"), 14 * kSecond, 4, BypassWay::kLeftLane});
  // R2 comes through the borrowed lane until 20 s.
  EXPECT_EQ(told(network, after.charts[1]), "Cur-Pos 14, x0y0 20");
  EXPECT_EQ(told(network, after.charts[0]), "Cur-Pos 25, x1y0 31, x2y0 41");
}

TEST_F(Planning, WhoPassesInsideItsLaneKeepsItsChartAndOthersAvoidTheLane) {
  const Plan plan = make_plan(network_, {one("R1", 1, 0, "B3", "B7"), one("R2", 1, 0, "B1", "B5")});
  for (const BypassWay way : {BypassWay::kRightInLane, BypassWay::kLeftInLane}) {
    const Plan after = bypass(network_, plan, met(0, "B3", "B3B5", 10, 0.5, way));
    EXPECT_EQ(chart(after, 0), "Cur-Pos 10, B3B5 40, B5 60, B5B7 100, B7 120");
    EXPECT_THAT(told(network_, after), Contains("R1 passes inside its lane, B3 to B3B5"));
    EXPECT_THAT(told(network_, after), Contains("R2 has a new way from B1B3"));
  }
}

TEST_F(Planning, WithoutRoomItGoesBackAndPlansAgain) {
  const Plan plan = make_plan(network_, {one("R1", 1, 0, "B3", "B7")});
  const Plan after = bypass(network_, plan, met(0, "B3", "B3B5", 10, 0.25, BypassWay::kReverse));
  EXPECT_THAT(told(network_, after), ElementsAre("R1 sees at 10 s that B3 to B3B5 is blocked",
                                                 "B3 to B3B5 is closed to all",
                                                 "R1 goes back to B3", "R1 has a new way from B3"));
  EXPECT_THAT(chart(after), HasSubstr("Cur-Pos 10, B3 20, C8C10 40, C3 60"));
}

TEST_F(Planning, WhoFollowsGoesBackTooAndWhoIsAheadDoesNot) {
  const Plan plan = make_plan(network_, {one("R1", 1, 10, "B3", "B7"), one("R2", 1, 20, "B3", "B7"),
                                         one("R3", 1, 0, "B3", "B7")});
  const Plan after = bypass(network_, plan, met(0, "B3", "B3B5", 30, 0.5, BypassWay::kReverse));
  EXPECT_THAT(chart(after, 0), HasSubstr("Cur-Pos 30, B3 50"));
  EXPECT_THAT(chart(after, 1), HasSubstr("Cur-Pos 30, B3 40"));
  EXPECT_EQ(chart(after, 2), "Cur-Pos 30, B3B5 40, B5 60, B5B7 100, B7 120");
}

TEST_F(Planning, ALaneBesideThatIsBlockedIsNotBorrowed) {
  const Plan plan = make_plan(network_, {one("R1", 1, 0, "B3", "B7")});
  const Plan blocked = lane_blocked(network_, plan, seen(0, "B8", "B8B10", 5));
  const Plan after =
      bypass(network_, blocked, met(0, "B3", "B3B5", 10, 0.25, BypassWay::kLeftLane));
  EXPECT_THAT(told(network_, after), Contains("R1 goes back to B3"));
}

TEST(PlanningOnALine, ALaneBesideThatRunsTheSameWayIsNotBorrowed) {
  lanes::NetworkDescription description{{{"lane", 1, 4, 1}},
                                        {{"a", 0, 0}, {"b", 50, 0}, {"c", 0, 4}, {"d", 50, 4}},
                                        {{0, 1, 0, std::nullopt, 2}, {1, 0, 0}, {2, 3, 0}}};
  const auto after = [&] {
    const LaneNetwork network(description);
    const Plan plan = make_plan(network, {robot(network, "R1", 1, 0, "a", "b")});
    return told(network, bypass(network, plan, {0, 0, 10 * kSecond, 10, BypassWay::kLeftLane}));
  };
  EXPECT_THAT(after(), Contains("R1 goes back to a"));
  std::swap(description.lanes[2].from, description.lanes[2].to);
  EXPECT_THAT(after(), Contains("R1 takes the lane beside, d to c, against its direction"));
  // A robot that is wider than that lane cannot take it.
  description.classes.push_back({"narrow", 1, 2, 1});
  description.lanes[2].lane_class = 1;
  const LaneNetwork network(description);
  Robot wide = robot(network, "R1", 1, 0, "a", "b");
  wide.width = 3;
  const Plan plan = make_plan(network, {wide});
  EXPECT_THAT(told(network, bypass(network, plan, {0, 0, 10 * kSecond, 10, BypassWay::kLeftLane})),
              Contains("R1 goes back to a"));
}

TEST_F(Planning, ABypassIsDrivenToItsEndWhateverIsReportedMeanwhile) {
  const Plan plan = make_plan(network_, {one("R1", 1, 0, "B3", "B7")});
  const Plan bypassing =
      bypass(network_, plan, met(0, "B3", "B3B5", 10, 0.25, BypassWay::kLeftLane));
  EXPECT_EQ(chart(bypassing), "Cur-Pos 10, B8 40, B3B5 60, B5 80, B5B7 120, B7 140");
  const Plan after = lane_blocked(network_, bypassing, seen(0, "B3B5", "B5", 20));
  EXPECT_TRUE(is_out_of_lane(after.charts[0]));
  EXPECT_THAT(chart(after), HasSubstr("Cur-Pos 20, B8 40, B3B5 60, B8 80"));
}

TEST_F(Planning, WhoStandsInTheMiddleOfABypassGoesOnWithIt) {
  const Plan plan = make_plan(network_, {one("R1", 1, 0, "B3", "B7")});
  const Plan bypassing =
      bypass(network_, plan, met(0, "B3", "B3B5", 10, 0.25, BypassWay::kLeftLane));
  const Plan after = lane_blocked(network_, bypassing, seen(0, "B3B5", "B5", 40));
  EXPECT_EQ(after.charts[0].passed, node(network_, "B8"));
  EXPECT_THAT(chart(after), HasSubstr("Cur-Pos 40, B3B5 60, B8 80"));
  EXPECT_THAT(told(network_, after), Contains("R1 has a new way from B3B5"));
}

TEST_F(Planning, ABypassThatIsBlockedEndsAtTheNodeWhereTheLaneBegan) {
  const Plan plan =
      make_plan(network_, {one("R1", 1, 0, "B3", "B7"), one("R2", 1, 10, "B6", "B10")});
  const Plan bypassing =
      bypass(network_, plan, met(0, "B3", "B3B5", 10, 0.25, BypassWay::kLeftLane));
  ASSERT_EQ(chart(bypassing, 0).substr(0, 26), "Cur-Pos 10, B8 40, B3B5 60");
  const Plan after =
      bypass(network_, bypassing, met(0, "B3", "B3B5", 20, 0.5, BypassWay::kReverse));
  EXPECT_THAT(chart(after, 0), HasSubstr("Cur-Pos 20, B3 40, C8C10 60"));
  EXPECT_EQ(after.closed.size(), 2U);
  EXPECT_THAT(told(network_, after), Contains("B8 to B8B10 is closed to all"));
  EXPECT_THAT(told(network_, after), Contains("R2 has a new way from B6B8"));
  // On its way back it has nothing to report, also not as if it were on a bypass there.
  EXPECT_THROW(bypass(network_, after, met(0, "B8", "B8B10", 21, 0.5, BypassWay::kReverse)),
               std::invalid_argument);
  EXPECT_THROW(bypass(network_, after, met(0, "B3", "B3B5", 21, 0.5, BypassWay::kLeftLane)),
               std::invalid_argument);
}

// R2 comes through the lane that R1 is to borrow until 30 s; R1 waits until 35 s.
class WaitingToBypass : public Planning {
 protected:
  WaitingToBypass()
      : plan_(bypass(
            network_,
            make_plan(network_, {one("R1", 1, 0, "B3", "B7"), one("R2", 2, -0, "B8", "B10")}),
            met(0, "B3", "B3B5", 10, 0.25, BypassWay::kLeftLane))) {}
  Plan plan_;
};

TEST_F(WaitingToBypass, IsAsTheseTestsWantIt) {
  EXPECT_EQ(chart(plan_), "Cur-Pos 45, B8 75, B3B5 95, B5 115, B5B7 155, B7 175");
  EXPECT_EQ(told(network_, chart_at(plan_.charts[0], 20 * kSecond)), chart(plan_));
}

TEST_F(WaitingToBypass, GoesBackWhenTheLaneBesideIsBlockedToo) {
  const Plan after = lane_blocked(network_, plan_, seen(1, "B8", "B8B10", 20));
  EXPECT_THAT(told(network_, after), Contains("R1 goes back to B3"));
  EXPECT_THAT(chart(after), HasSubstr("Cur-Pos 20, B3 30, C8C10 50"));
}

TEST_F(WaitingToBypass, MayFindThatItNeedNotLeaveItsLane) {
  const Plan after =
      bypass(network_, plan_, met(0, "B3", "B3B5", 20, 0.25, BypassWay::kRightInLane));
  EXPECT_EQ(chart(after), "Cur-Pos 20, B3B5 50, B5 70, B5B7 110, B7 130");
}

TEST_F(WaitingToBypass, MayReportAgain) {
  const Plan after = bypass(network_, plan_, met(0, "B3", "B3B5", 20, 0.25, BypassWay::kLeftLane));
  EXPECT_EQ(chart(after), chart(plan_));
}

TEST_F(WaitingToBypass, GoesBackWithTheOneAheadOfIt) {
  Plan plan = make_plan(network_, {one("R1", 1, 10, "B3", "B7"), one("R2", 2, 0, "B8", "B10"),
                                   one("R3", 1, 0, "B3", "B7")});
  plan = bypass(network_, plan, met(0, "B3", "B3B5", 20, 0.25, BypassWay::kLeftLane));
  plan = bypass(network_, plan, met(2, "B3", "B3B5", 22, 0.55, BypassWay::kReverse));
  EXPECT_THAT(told(network_, plan), Contains("R1 goes back to B3"));
  EXPECT_THAT(told(network_, plan), Contains("R3 goes back to B3"));
  // A second report of the one ahead leaves the one behind on its way back.
  const std::string before = chart(plan, 0);
  plan = bypass(network_, plan, met(2, "B3", "B3B5", 22, 0.55, BypassWay::kReverse));
  EXPECT_EQ(chart(plan, 0), before);
}

TEST_F(Planning, WhoWaitsForTheSameBypassGoesBackWhenItIsBlocked) {
  Plan plan = make_plan(network_, {one("R1", 2, 0, "B3", "B7"), one("R2", 1, 5, "B3", "B7")});
  plan = bypass(network_, plan, met(0, "B3", "B3B5", 10, 0.25, BypassWay::kLeftLane));
  plan = bypass(network_, plan, met(1, "B3", "B3B5", 12, 0.25, BypassWay::kLeftLane));
  EXPECT_THAT(chart(plan, 1), HasSubstr("Cur-Pos 17, B8 47"));
  plan = bypass(network_, plan, met(0, "B3", "B3B5", 14, 0.35, BypassWay::kReverse));
  EXPECT_THAT(told(network_, plan), Contains("R2 goes back to B3"));
}

TEST_F(Planning, WhoWaitsToGoBackMayFindThatItNeedNot) {
  Plan plan = make_plan(network_, {one("R1", 1, 40, "B3", "B7"), one("R2", 2, 0, "B1", "C3")});
  plan = bypass(network_, plan, met(0, "B3", "B3B5", 50, 0.25, BypassWay::kReverse));
  EXPECT_THAT(chart(plan), HasSubstr("Cur-Pos 55, B3 65"));  // R2 is there at 60
  for (const BypassWay way : {BypassWay::kRightInLane, BypassWay::kLeftLane}) {
    const Plan after = bypass(network_, plan, met(0, "B3", "B3B5", 52, 0.25, way));
    EXPECT_EQ(chart(after), way == BypassWay::kRightInLane
                                ? "Cur-Pos 52, B3B5 82, B5 102, B5B7 142, B7 162"
                                : "Cur-Pos 52, B8 82, B3B5 102, B5 122, B5B7 162, B7 182");
  }
}

TEST(PlanningOnALine, AStrandedRobotReturnsWhenTheWayBackIsFree) {
  const LaneNetwork network(lanes::grid({3, 1, 10}));
  Plan plan = make_plan(network, {robot(network, "R1", 1, 0, "x0y0", "x2y0")});
  const LaneIndex ahead = lane(network, "x1y0", "x2y0");
  const LaneIndex back = lane(network, "x1y0", "x0y0");
  plan = lane_blocked(network, plan, {0, back, 5 * kSecond});
  plan = lane_blocked(network, plan, {0, ahead, 5 * kSecond});
  EXPECT_EQ(plan.errands[0], Errand::kStranded);
  plan = lane_free(network, plan, {0, back, 20 * kSecond});
  EXPECT_EQ(plan.errands[0], Errand::kBack);
  EXPECT_EQ(told(network, plan.charts[0]), "Cur-Pos 20, x0y0 30");
}

TEST(PlanningOnALine, AWayAcrossWithoutEndIsNotSettledAndNothingOverflows) {
  const LaneNetwork network({{{"lane", 1, 4, 1}},
                             {{"a", 0, 0}, {"b", 10, 0}, {"c", 1e300, 0}, {"d", -1e300, 0}},
                             {{0, 1, 0, 10.0, 1}, {2, 3, 0, 10.0}}});
  const Plan plan = make_plan(network, {robot(network, "R1", 1, 0, "a", "b")});
  const Plan after = bypass(network, plan, {0, 0, 5 * kSecond, 5, BypassWay::kReverse});
  EXPECT_EQ(after.errands[0], Errand::kStranded);
  // Both distances are infinite, so neither end is nearer: the lane is not borrowed.
  EXPECT_THAT(told(network, bypass(network, plan, {0, 0, 5 * kSecond, 5, BypassWay::kLeftLane})),
              Contains("R1 goes back to a"));
}

TEST_F(Planning, ChartsKnowWhenARobotEnteredItsLane) {
  // It waits at B3 until 110, and only then enters the lane.
  Chart chart = make_plan(network_, {one("R1", 1, 0, "B3", "B7")}).charts[0];
  for (std::size_t i = 1; i < chart.stops.size(); ++i) chart.stops[i].arrival += 100 * kSecond;
  Chart waiting = chart_at(chart, 60 * kSecond);
  for (std::size_t i = 1; i < waiting.stops.size(); ++i) waiting.stops[i].arrival += 10 * kSecond;
  EXPECT_EQ(chart_at(waiting, 120 * kSecond).entered, 110 * kSecond);
  // On a bypass it has entered the lane beside when it left its own.
  const Plan plan = make_plan(network_, {one("R1", 1, 0, "B3", "B7")});
  const Plan bypassing =
      bypass(network_, plan, met(0, "B3", "B3B5", 10, 0.25, BypassWay::kLeftLane));
  EXPECT_EQ(chart_at(bypassing.charts[0], 20 * kSecond).entered, 10 * kSecond);
}

TEST_F(Planning, ChartsAtLaterTimesKeepWhatIsAhead) {
  const Plan plan = make_plan(network_, {one("R1", 1, 10, "B3", "B7")});
  const Chart& whole = plan.charts[0];
  const auto at = [&](int seconds) { return chart_at(whole, seconds * kSecond); };
  EXPECT_EQ(told(network_, at(9)), told(network_, whole));
  EXPECT_EQ(told(network_, at(10)), "Cur-Pos 10, B3B5 50, B5 70, B5B7 110, B7 130");
  EXPECT_EQ(at(10).stops[0].lane, kNone);  // stands at B3
  EXPECT_EQ(at(10).passed, node(network_, "B3"));
  EXPECT_EQ(at(20).stops[0].lane, lane(network_, "B3", "B3B5"));
  EXPECT_EQ(at(20).stops[1].travel, 30 * kSecond);
  EXPECT_EQ(at(20).entered, 10 * kSecond);
  EXPECT_EQ(at(50).passed, node(network_, "B3B5"));
  EXPECT_EQ(told(network_, at(130)), "Cur-Pos 130");
  EXPECT_EQ(at(200).passed, node(network_, "B7"));
  // In two steps as in one.
  EXPECT_EQ(told(network_, chart_at(at(20), 60 * kSecond)), told(network_, at(60)));
  EXPECT_EQ(chart_at(at(20), 30 * kSecond).entered, 10 * kSecond);
  EXPECT_EQ(chart_at(at(20), 30 * kSecond).stops[1].travel, 20 * kSecond);
}

TEST_F(Planning, ARobotThatWaitsAtANodeStandsThere) {
  Chart chart = make_plan(network_, {one("R1", 1, 0, "B3", "B7")}).charts[0];
  for (std::size_t i = 1; i < chart.stops.size(); ++i) chart.stops[i].arrival += 100 * kSecond;
  const Chart waiting = chart_at(chart, 60 * kSecond);
  EXPECT_EQ(waiting.stops[0].lane, kNone);
  EXPECT_EQ(waiting.passed, node(network_, "B3"));
  const Chart driving = chart_at(waiting, 110 * kSecond);
  EXPECT_EQ(driving.stops[0].lane, lane(network_, "B3", "B3B5"));
  EXPECT_EQ(driving.entered, 100 * kSecond);
}

TEST_F(Planning, RefusesWhatMakesNoSense) {
  const auto refused = [&](const Robot& robot) {
    EXPECT_THROW(make_plan(network_, {robot}), std::invalid_argument);
  };
  Robot good = one("R1", 1, 0, "B3", "B7");
  Robot bad = good;
  bad.from = kNone;
  refused(bad);
  bad = good;
  bad.goal = network_.node_count();
  refused(bad);
  bad = good;
  bad.start = -1;
  refused(bad);
  bad = good;
  bad.speed = 0;
  refused(bad);

  const Plan plan = make_plan(network_, {good});
  EXPECT_THROW(lane_blocked(network_, plan, {1, 0, 0}), std::invalid_argument);
  EXPECT_THROW(lane_blocked(network_, plan, {0, network_.lane_count(), 0}), std::invalid_argument);
  EXPECT_THROW(lane_free(network_, plan, {kNone, 0, 0}), std::invalid_argument);
  const Plan later = lane_blocked(network_, plan, {0, 0, 50 * kSecond});
  EXPECT_THROW(lane_blocked(network_, later, {0, 0, 49 * kSecond}), std::invalid_argument);
  EXPECT_THROW(bypass(network_, plan, met(0, "B5", "B5B7", 10, 0.5, BypassWay::kLeftLane)),
               std::invalid_argument);
  EXPECT_THROW(bypass(network_, plan, met(0, "B3", "B3B5", 10, 1, BypassWay::kLeftLane)),
               std::invalid_argument);
  EXPECT_THROW(bypass(network_, plan, met(0, "B3", "B3B5", 10, -0.1, BypassWay::kLeftLane)),
               std::invalid_argument);
  try {
    bypass(network_, plan, met(0, "B3", "B3B5", 45, 0.5, BypassWay::kLeftLane));
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "bypass: R1 is not on B3 to B3B5 at 45 s");
  }
}

}  // namespace
}  // namespace rubicon::charts
