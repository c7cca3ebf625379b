#include <gtest/gtest.h>

#include "src/motion/guides/guide.hpp"
#include "tests/unit/guides/guide_machines.hpp"

namespace rubicon::guides {
namespace {

using Q = std::vector<double>;
using Kind = GuideAnswer::Kind;

class PlannedGuideTest : public ::testing::Test {
 protected:
  GuideTask task(std::vector<Q> goals) {
    return {&model_, test::standing(model_), std::move(goals), false};
  }

  const robot::RobotModel model_ = test::gantry();
  test::PredicateTests wall_{
      [](std::span<const double> q) { return q[0] > 4 && q[0] < 6 && q[1] < 8; }};
  const GuideSpec spec_ = default_guide(GuideKind::rrt_connect);
};

TEST_F(PlannedGuideTest, HandsOutItsWayPointsInOrder) {
  const auto guide = make_guide(spec_, task({{9, 1}}));
  GuideAnswer answer = guide->begin(Q{1, 1}, wall_);
  ASSERT_TRUE(answer.planned);
  ASSERT_TRUE(answer.planned->found());
  const std::vector<Q> way = answer.planned->way;
  EXPECT_EQ(way.front(), (Q{1, 1}));
  ASSERT_GE(way.size(), 3u);
  for (std::size_t i = 1; i < way.size(); ++i) {
    EXPECT_EQ(answer.kind, Kind::way_point);
    EXPECT_EQ(answer.q, way[i]);
    EXPECT_EQ(answer.k, static_cast<int>(i));
    EXPECT_EQ(answer.leads_to_goal(), i + 1 == way.size());
    if (!answer.leads_to_goal()) answer = guide->reached(way[i], wall_);
  }
  EXPECT_EQ(answer.q, (Q{9, 1}));
}

TEST_F(PlannedGuideTest, TakesTheFirstGoalThatItMayStandAt) {
  const PlanReport report = plan_way(spec_, task({{5, 1}, {9, 2}, {9, 1}}), Q{1, 1}, wall_);
  ASSERT_TRUE(report.found());
  EXPECT_EQ(report.way.back(), (Q{9, 2}));
}

TEST_F(PlannedGuideTest, SaysWhetherStartOrGoalIsInTheWay) {
  EXPECT_EQ(plan_way(spec_, task({{9, 1}}), Q{5, 1}, wall_).outcome,
            PlanReport::Outcome::start_blocked);
  EXPECT_EQ(plan_way(spec_, task({{5, 1}}), Q{1, 1}, wall_).outcome,
            PlanReport::Outcome::goal_blocked);
}

TEST_F(PlannedGuideTest, SaysWhereWhatItKeepsDoesNotHold) {
  GuideSpec spec = spec_;
  spec.keep = {{{{1, 1.0}}, 5}};  // y <= 5
  EXPECT_EQ(plan_way(spec, task({{9, 1}}), Q{1, 6}, wall_).outcome,
            PlanReport::Outcome::start_not_kept);
  EXPECT_EQ(plan_way(spec, task({{9, 6}}), Q{1, 1}, wall_).outcome,
            PlanReport::Outcome::goal_not_kept);
  spec.checks = 3000;
  EXPECT_EQ(plan_way(spec, task({{9, 1}}), Q{1, 1}, wall_).outcome,
            PlanReport::Outcome::out_of_checks);
}

TEST_F(PlannedGuideTest, ACopyGoesOnByItself) {
  const auto guide = make_guide(spec_, task({{9, 1}}));
  const std::vector<Q> way = guide->begin(Q{1, 1}, wall_).planned->way;
  const auto copy = guide->copy();
  EXPECT_EQ(copy->reached(way[1], wall_).q, way[2]);
  EXPECT_EQ(guide->reached(way[1], wall_).q, way[2]);
}

TEST_F(PlannedGuideTest, PlansAgainAsOftenAsItMay) {
  GuideSpec spec = spec_;
  spec.replans = 2;
  const auto guide = make_guide(spec, task({{9, 1}}));
  EXPECT_EQ(guide->begin(Q{1, 1}, wall_).kind, Kind::way_point);
  for (int n = 0; n < 2; ++n) {
    const GuideAnswer again = guide->ended_short(Q{1, 2}, wall_);
    EXPECT_EQ(again.kind, Kind::way_point);
    ASSERT_TRUE(again.planned);
    EXPECT_EQ(again.planned->way.front(), (Q{1, 2}));
  }
  const GuideAnswer last = guide->ended_short(Q{1, 2}, wall_);
  EXPECT_EQ(last.kind, Kind::gave_up);
  EXPECT_EQ(last.reason, "3 ways were planned");
}

TEST_F(PlannedGuideTest, ARoadmapIsKeptForTheNextPlanAndCopied) {
  GuideSpec spec = default_guide(GuideKind::prm);
  spec.improve = 0;
  const auto guide = make_guide(spec, task({{9, 1}}));
  const GuideAnswer first = guide->begin(Q{1, 1}, wall_);
  ASSERT_TRUE(first.planned->found());
  const auto copy = guide->copy();
  const GuideAnswer again = guide->ended_short(Q{1, 2}, wall_);
  ASSERT_TRUE(again.planned->found());
  // What was in the way is not tested again: all that is refused is by the legs from the new start.
  EXPECT_LT(again.planned->refused, first.planned->refused / 2);
  const GuideAnswer of_copy = copy->ended_short(Q{1, 2}, wall_);
  EXPECT_EQ(of_copy.planned->way, again.planned->way);
  EXPECT_EQ(of_copy.planned->checks, again.planned->checks);
}

TEST_F(PlannedGuideTest, ShortcutsLeaveASafeWayAlone) {
  const auto checks_and_way = [&](double safety, double improve) {
    GuideSpec spec = default_guide(GuideKind::astar);
    spec.safety = safety;
    spec.improve = improve;
    const PlanReport report = plan_way(spec, task({{9, 1}}), Q{1, 1}, wall_);
    return std::make_pair(report.checks, report.way);
  };
  EXPECT_GT(checks_and_way(0, 200).first, checks_and_way(0, 0).first);
  EXPECT_EQ(checks_and_way(1, 200), checks_and_way(1, 0));
}

/// The engine may refuse steps whose whole leg it has found free: then legs are tested as steps.
class PickyTests : public test::PredicateTests {
 public:
  using PredicateTests::PredicateTests;
  bool sweeps_free(std::span<const double> q_from, std::span<const double> q_to) override {
    // Near y = 9.5 no short step is free.
    const double length = std::abs(q_to[0] - q_from[0]) + std::abs(q_to[1] - q_from[1]);
    if (length <= 2 && q_from[1] > 9.2 && q_from[0] > 4 && q_from[0] < 6) return false;
    return PredicateTests::sweeps_free(q_from, q_to);
  }
};

TEST_F(PlannedGuideTest, WhatItFindsFreeCanBeFollowed) {
  for (double seed = 1; seed <= 30; ++seed) {
    PickyTests picky([](std::span<const double> q) { return q[0] > 4 && q[0] < 6 && q[1] < 9; });
    GuideSpec spec = spec_;
    spec.seed = seed;
    spec.checks = 20000;
    const PlanReport report = plan_way(spec, task({{9, 1}}), Q{1, 1}, picky);
    if (!report.found()) continue;
    const Leg leg(model_, test::standing(model_));
    Q q = report.way.front();
    Q steps(2);
    for (const Q& point : report.way) {
      while (leg.next_step(q, point, steps)) {
        const Q next{q[0] + steps[0], q[1] + steps[1]};
        ASSERT_TRUE(picky.sweeps_free(q, next)) << "seed " << seed;
        q = next;
      }
    }
  }
}

}  // namespace
}  // namespace rubicon::guides
