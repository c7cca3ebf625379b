// Reports of robots and what the centre makes of them, on networks small enough to know the answer.
#include "src/fleets/charts/reports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/charts/chart_fixtures.hpp"

namespace rubicon::charts {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// a - b - c - d in a row, 10 s each, and from b round by e to c, 20 s each; all both ways.
LaneNetwork row_with_detour() {
  lanes::NetworkDescription description;
  description.classes = {{"road", 1, 4, 1}};
  const std::vector<std::pair<const char*, std::pair<double, double>>> places = {
      {"a", {0, 0}}, {"b", {10, 0}}, {"c", {20, 0}}, {"d", {30, 0}}, {"e", {15, 10}}};
  for (const auto& [name, at] : places) {
    description.nodes.push_back({name, at.first, at.second, 0, true});
  }
  const auto both = [&](int from, int to, double length) {
    const auto first = static_cast<LaneIndex>(description.lanes.size());
    description.lanes.push_back({from, to, 0, length, kNone});
    description.lanes.push_back({to, from, 0, length, first});
  };
  both(0, 1, 10);
  both(1, 2, 10);
  both(2, 3, 10);
  both(1, 4, 20);
  both(4, 2, 20);
  return LaneNetwork(std::move(description));
}

class Reports : public testing::Test {
 protected:
  SiteReport report(SiteReport::Kind kind, RobotIndex by, const std::string& from,
                    const std::string& to, int seconds) const {
    return {kind, by, lane(network_, from, to), seconds * kSecond, 0, 0};
  }
  Course course(const std::vector<Robot>& robots, const std::vector<SiteReport>& reports) const {
    auto result = carry_out(network_, robots, {}, reports);
    if (const auto* fault = std::get_if<ReportFault>(&result)) {
      ADD_FAILURE() << fault->message;
      return {};
    }
    return std::get<Course>(std::move(result));
  }
  ReportFault fault(const std::vector<Robot>& robots,
                    const std::vector<SiteReport>& reports) const {
    auto result = carry_out(network_, robots, {}, reports);
    if (auto* fault = std::get_if<ReportFault>(&result)) return *fault;
    ADD_FAILURE() << "nothing wrong was found";
    return {};
  }
  std::vector<std::string> way(const Journey& journey) const {
    std::vector<std::string> text;
    for (const Visit& visit : journey.visits) {
      text.push_back(
          (visit.node == kNone ? std::string("-") : network_.node(visit.node).name) + " " +
          seconds_told(visit.arrival) +
          (visit.departure > visit.arrival ? " to " + seconds_told(visit.departure) : ""));
    }
    return text;
  }

  LaneNetwork network_ = row_with_detour();
  Robot first_ = robot(network_, "r1", 2, 0, "a", "d");
  Robot second_ = robot(network_, "r2", 1, 20, "a", "d");
};

TEST_F(Reports, WithoutAnyTheFirstPlanIsGone) {
  const Course all = course({first_, second_}, {});
  ASSERT_EQ(all.steps.size(), 1U);
  EXPECT_THAT(way(all.journeys[0]), ElementsAre("a 0", "b 10", "c 20", "d 30"));
  EXPECT_EQ(all.journeys[0].waiting(), 0);
  EXPECT_EQ(all.journeys[0].driving(), 30 * kSecond);
  EXPECT_EQ(all.journeys[0].alone, 30 * kSecond);
}

TEST_F(Reports, ABlockedLaneIsAvoidedByAllUntilItIsReopened) {
  // r1 stands at b and sees that b to c is blocked: it goes round, and so does r2, which is not
  // there yet. At 35 s r2 is at b, and sees that the lane is free; it takes it.
  const Course all =
      course({first_, second_}, {report(SiteReport::Kind::kBlocked, 0, "b", "c", 10),
                                 report(SiteReport::Kind::kReopened, 1, "b", "c", 30)});
  ASSERT_EQ(all.steps.size(), 3U);
  EXPECT_EQ(all.steps[1].plan.closed, std::vector<LaneIndex>{lane(network_, "b", "c")});
  EXPECT_EQ(
      told(network_, all.steps[1].plan.charts),
      (std::vector<std::string>{"Cur-Pos 10, e 30, c 50, d 60", "a 20, b 30, e 50, c 70, d 80"}));
  EXPECT_TRUE(all.steps[1].doubt.empty());
  EXPECT_TRUE(all.steps[2].plan.closed.empty());
  EXPECT_THAT(way(all.journeys[0]), ElementsAre("a 0", "b 10", "e 30", "c 50", "d 60"));
  EXPECT_THAT(way(all.journeys[1]), ElementsAre("a 20", "b 30", "c 40", "d 50"));
  EXPECT_THAT(told(network_, all.steps[1].plan),
              ElementsAre("r1 sees at 10 s that b to c is blocked", "b to c is closed to all",
                          "r1 has a new way from b", "r2 has a new way from a"));
  EXPECT_THAT(told(network_, all.steps[2].plan),
              ElementsAre("b to c is open again", "r2 has a new way from b"));
}

TEST_F(Reports, WhoDrivesOnWhileOthersReportHasOneWayWithoutABreak) {
  // r2 is half way from a to b when r1 reports.
  second_.start = 5 * kSecond;
  const Course all =
      course({first_, second_}, {report(SiteReport::Kind::kBlocked, 0, "b", "c", 10)});
  EXPECT_THAT(way(all.journeys[1]), ElementsAre("a 5", "b 15", "e 35", "c 55", "d 65"));
  EXPECT_EQ(all.journeys[1].driving(), 60 * kSecond);
  EXPECT_EQ(all.journeys[1].alone, 30 * kSecond);
}

TEST_F(Reports, AnObstacleIsPassedByTheRoomThatItLeaves) {
  first_.width = 2;
  SiteReport seen = report(SiteReport::Kind::kObstacle, 0, "b", "c", 14);
  const auto answer = [&](double from, double to) {
    seen.obstacle_from = from;
    seen.obstacle_to = to;
    return course({first_}, {seen});
  };
  const Course right = answer(2, 4);
  EXPECT_EQ(right.steps[1].bypass.way, BypassWay::kRightInLane);
  EXPECT_DOUBLE_EQ(right.steps[1].travelled, 4);
  EXPECT_THAT(way(right.journeys[0]), ElementsAre("a 0", "b 10", "c 20", "d 30"));
  EXPECT_EQ(answer(0, 2).steps[1].bypass.way, BypassWay::kLeftInLane);

  // The lane beside begins at c itself: 6 s more, as in its own.
  const Course left = answer(0, 3);
  EXPECT_EQ(left.steps[1].bypass.way, BypassWay::kLeftLane);
  EXPECT_THAT(way(left.journeys[0]), ElementsAre("a 0", "b 10", "- 14", "c 20", "d 30"));
  EXPECT_EQ(left.journeys[0].visits[3].leg, Leg::kAgainst);

  // Back to b, 4 s, and round.
  const Course back = answer(0, 8);
  EXPECT_EQ(back.steps[1].bypass.way, BypassWay::kReverse);
  EXPECT_THAT(way(back.journeys[0]),
              ElementsAre("a 0", "b 10", "- 14", "b 18", "e 38", "c 58", "d 68"));
  EXPECT_EQ(back.journeys[0].driving(), 68 * kSecond);
}

TEST_F(Reports, WhoIsBehindGoesBackTooWhoeverCameFirst) {
  // r1 is slow, and r2 has overtaken it when it finds the way blocked.
  first_.speed = 0.25;
  first_.start = 0;
  first_.width = second_.width = 2;
  second_.start = 35;
  second_.start *= kSecond;
  SiteReport seen = report(SiteReport::Kind::kObstacle, 1, "b", "c", 54);
  seen.obstacle_to = 8;
  const Course all = course({first_, second_}, {seen});
  // At 54 s r1 has 3.5 m of the lane behind it, r2 9 m.
  EXPECT_THAT(way(all.journeys[0]),
              ElementsAre("a 0", "b 40", "- 54", "b 68", "e 148", "c 228", "d 268"));
  EXPECT_THAT(way(all.journeys[1]),
              ElementsAre("a 35", "b 45", "- 54", "b 63", "e 83", "c 103", "d 113"));
}

TEST_F(Reports, WaitsAreOfThePlaceWhereTheyAre) {
  // Both at a at 0: r2 starts 5 s later.
  second_.start = 0;
  const Course all = course({first_, second_}, {});
  EXPECT_THAT(way(all.journeys[1]), ElementsAre("a 0 to 5", "b 15", "c 25", "d 35"));
  EXPECT_EQ(all.journeys[1].waiting(), 5 * kSecond);
  EXPECT_EQ(all.journeys[1].yields, 1);
  EXPECT_EQ(all.journeys[1].delayed, 5 * kSecond);
}

TEST_F(Reports, WhoHasNoWayLeftReturns) {
  const Course all = course({first_}, {report(SiteReport::Kind::kBlocked, 0, "b", "c", 10),
                                       report(SiteReport::Kind::kBlocked, 0, "b", "e", 10)});
  EXPECT_EQ(all.steps[2].plan.errands[0], Errand::kBack);
  EXPECT_THAT(way(all.journeys[0]), ElementsAre("a 0", "b 10", "a 20"));
}

TEST_F(Reports, WhoReturnsTakesALaneThatIsReopened) {
  const auto at_c = [&](SiteReport::Kind kind, const char* to) {
    return report(kind, 0, "c", to, 20);
  };
  std::vector<SiteReport> reports = {at_c(SiteReport::Kind::kBlocked, "d"),
                                     at_c(SiteReport::Kind::kBlocked, "b")};
  EXPECT_THAT(way(course({first_}, reports).journeys[0]),
              ElementsAre("a 0", "b 10", "c 20", "e 40", "b 60", "a 70"));
  reports.push_back(at_c(SiteReport::Kind::kReopened, "b"));
  EXPECT_THAT(way(course({first_}, reports).journeys[0]),
              ElementsAre("a 0", "b 10", "c 20", "b 30", "a 40"));
}

TEST_F(Reports, SaysWhatCannotBe) {
  EXPECT_THAT(
      fault({first_, second_}, {report(SiteReport::Kind::kBlocked, 1, "b", "c", 10)}).message,
      HasSubstr("r2 starts at 20 s: at 10 s it sees nothing"));
  EXPECT_THAT(fault({first_}, {report(SiteReport::Kind::kReopened, 0, "b", "c", 10)}).message,
              HasSubstr("the lane b to c is open at 10 s"));
  EXPECT_THAT(fault({first_}, {report(SiteReport::Kind::kBlocked, 0, "b", "c", 14)}).message,
              HasSubstr("what it finds there is an obstacle"));
  first_.width = 2;
  const ReportFault late = fault({first_}, {report(SiteReport::Kind::kObstacle, 0, "b", "c", 5)});
  EXPECT_THAT(late.message,
              HasSubstr("r1 is not in the lane b to c at 5 s: it is on its way from a to b"));
  EXPECT_EQ(late.hint, "it is there after 10 s and before 20 s");
}

TEST_F(Reports, RobotsFindBarriersByThemselves) {
  // r1 meets it at b at 10 s, goes round, and returns at 100 s from d; r2 finds it gone at 30 s.
  const Barrier barrier{lane(network_, "b", "c"), 5 * kSecond, 25 * kSecond};
  const auto made = carry_out(network_, {first_, second_}, {}, {}, {barrier});
  const Course& all = std::get<Course>(made);
  ASSERT_EQ(all.steps.size(), 3U);
  EXPECT_EQ(all.steps[1].report->kind, SiteReport::Kind::kBlocked);
  EXPECT_EQ(all.steps[1].report->robot, 0);
  EXPECT_EQ(all.steps[1].time, 10 * kSecond);
  EXPECT_EQ(all.steps[2].report->kind, SiteReport::Kind::kReopened);
  EXPECT_EQ(all.steps[2].report->robot, 1);
  EXPECT_EQ(all.steps[2].time, 30 * kSecond);
  EXPECT_THAT(way(all.journeys[0]), ElementsAre("a 0", "b 10", "e 30", "c 50", "d 60"));
  EXPECT_THAT(way(all.journeys[1]), ElementsAre("a 20", "b 30", "c 40", "d 50"));
  EXPECT_TRUE(all.steps[1].doubt.empty());
  EXPECT_TRUE(all.steps[2].doubt.empty());
}

TEST_F(Reports, ABarrierThatNobodyMeetsIsNotFound) {
  const LaneIndex of = lane(network_, "b", "c");
  // Before and after r1 enters the lane; and for good, on the lane back.
  const auto made = carry_out(network_, {first_}, {}, {},
                              {{of, 0, 10 * kSecond},
                               {of, 11 * kSecond, 20 * kSecond},
                               {lane(network_, "c", "b"), 0, lanes::kEndOfTime}});
  EXPECT_EQ(std::get<Course>(made).steps.size(), 1U);
  // At the very moment it counts.
  const auto met = carry_out(network_, {first_}, {}, {}, {{of, 10 * kSecond, 11 * kSecond}});
  EXPECT_THAT(way(std::get<Course>(met).journeys[0]),
              ElementsAre("a 0", "b 10", "e 30", "c 50", "d 60"));
}

TEST_F(Reports, DoubtsWhoIsTooFarAway) {
  const Course all = course({first_}, {report(SiteReport::Kind::kBlocked, 0, "b", "c", 5)});
  EXPECT_THAT(all.steps[1].doubt, HasSubstr("r1 can hardly see the lane b to c at 5 s"));
}

}  // namespace
}  // namespace rubicon::charts
