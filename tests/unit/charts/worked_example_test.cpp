// The worked example of the Blackmon paper, "Example of Collision Avoidance Algorithm for
// Bypassing": one chart of three robots before, and four after ROB1 finds an obstacle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/fleets/charts/plan.hpp"
#include "tests/unit/charts/chart_fixtures.hpp"

namespace rubicon::charts {
namespace {

using testing::ElementsAre;
using Charts = std::vector<std::string>;

const Charts kChart1 = {"B3 30, B3B5 70, B5 90, B5B7 130, B7 150",
                        "B6 0, B6B8 40, B8 60, B8B10 100, B10 120",
                        "C6C8 20, C8 40, B3B5 60, B8 80, B8B10 120, B10 140"};
const Charts kChart2 = {"Cur-Pos 35, B8 70, B3B5 90, B5 110, B5B7 150, B7 170",
                        "Cur-Pos 35, B6B8 40, B8 60, B8B10 100, B10 120",
                        "Cur-Pos 35, C8 40, B3B5 60, B8 80, B8B10 120, B10 140"};
const Charts kChart3 = {"Cur-Pos 105, B8 140, B3B5 160, B5 180, B5B7 220, B7 240", kChart2[1],
                        kChart2[2]};
const Charts kChart4 = {kChart3[0], kChart3[1],
                        "Cur-Pos 35, C8 40, B3B5 145, B8 165, B8B10 205, B10 225"};
const Charts kChart5 = {kChart3[0], kChart3[1],
                        "Cur-Pos 35, C8 40, B3B5 165, B8 185, B8B10 225, B10 245"};

class WorkedExample : public testing::Test {
 protected:
  Plan planned(const PlanSettings& settings = {}) const {
    return make_plan(
        network_,
        {robot(network_, "ROB1", 2, 30, "B3", "B7"), robot(network_, "ROB2", 3, 0, "B6", "B10"),
         robot(network_, "ROB3", 1, 20, "C6C8", "B10")},
        settings);
  }

  // After 5 s of the 40 from B3 to B3B5.
  Plan bypassed(const Plan& plan, const PlanSettings& settings = {}) const {
    const LaneIndex its_lane = lane(network_, "B3", "B3B5");
    return bypass(
        network_, plan,
        {0, its_lane, 35 * kSecond, network_.length(its_lane) * 5 / 40, BypassWay::kLeftLane},
        settings);
  }

  // The charts before any robot yielded, then after each time one did.
  std::vector<Charts> history(const Plan& plan) const {
    std::vector<Chart> charts = plan.charts;
    for (const Record& record : plan.records) {
      Record back = record;
      std::swap(back.before, back.after);
      apply_yield(back, charts);
    }
    std::vector<Charts> result = {told(network_, charts)};
    for (const Record& record : plan.records) {
      if (record.kind != RecordKind::kYields) continue;
      apply_yield(record, charts);
      result.push_back(told(network_, charts));
    }
    return result;
  }

  LaneNetwork network_{lanes::warehouse()};
};

TEST_F(WorkedExample, HasTheFiveChartsOfThePaper) {
  const Plan plan = planned();
  EXPECT_TRUE(plan.settled);
  EXPECT_EQ(told(network_, plan.charts), kChart1);
  EXPECT_TRUE(plan.records.empty());

  const Plan after = bypassed(plan);
  EXPECT_TRUE(after.settled);
  EXPECT_THAT(history(after), ElementsAre(kChart2, kChart3, kChart4, kChart5));
  EXPECT_EQ(told(network_, after.charts), kChart5);
}

TEST_F(WorkedExample, SaysWhoYieldsToWhomAndWhy) {
  EXPECT_THAT(
      told(network_, bypassed(planned())),
      ElementsAre("ROB1 sees at 35 s that B3 to B3B5 is blocked", "B3 to B3B5 is closed to all",
                  "ROB1 takes the lane beside, B8 to B8B10, against its direction",
                  "ROB1 yields to ROB2 at B8: Cur-Pos at 105 s, not 35 s (lane)",
                  "ROB3 yields to ROB1 at B8: B3B5 at 145 s, not 60 s (lane)",
                  "ROB3 yields to ROB1 at B8: B3B5 at 165 s, not 145 s (across)"));
}

TEST_F(WorkedExample, HoldsForEveryToleranceUpToFiveAndEveryDelay) {
  for (const int tolerance : {0, 1, 2, 3, 4, 5}) {
    for (const int delay : {1, 5, 10, 20}) {
      PlanSettings settings;
      settings.avoidance.tolerance = tolerance * kSecond;
      settings.avoidance.delay = delay * kSecond;
      const Plan plan = planned(settings);
      EXPECT_EQ(told(network_, plan.charts), kChart1);
      EXPECT_THAT(history(bypassed(plan, settings)),
                  ElementsAre(kChart2, kChart3, kChart4, kChart5));
    }
  }
  // B3B5 stays at 160 and 165: with more tolerance that is a conflict.
  PlanSettings settings;
  settings.avoidance.tolerance = 5 * kSecond + 1;
  EXPECT_NE(told(network_, bypassed(planned(settings), settings).charts), kChart5);
}

TEST_F(WorkedExample, OrderOfTheRobotsMakesNoDifference) {
  const std::vector<Robot> robots = planned().robots;
  std::vector<std::size_t> order = {0, 1, 2};
  do {
    std::vector<Robot> other;
    RobotIndex bypassing = kNone;
    for (const std::size_t i : order) {
      if (i == 0) bypassing = static_cast<RobotIndex>(other.size());
      other.push_back(robots[i]);
    }
    const LaneIndex its_lane = lane(network_, "B3", "B3B5");
    const Plan after = bypass(network_, make_plan(network_, other),
                              {bypassing, its_lane, 35 * kSecond,
                               network_.length(its_lane) * 5 / 40, BypassWay::kLeftLane});
    for (std::size_t k = 0; k < order.size(); ++k) {
      EXPECT_EQ(told(network_, after.charts[k]), kChart5[order[k]]);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_F(WorkedExample, IsPrintedAsATable) {
  const Plan after = bypassed(planned());
  EXPECT_EQ(table_text(network_, after.robots, after.charts),
            "ROB1 (priority 2)  ROB2 (priority 3)  ROB3 (priority 1)\n"
            "Cur-Pos 105        Cur-Pos  35        Cur-Pos  35\n"
            "B8      140        B6B8     40        C8       40\n"
            "B3B5    160        B8       60        B3B5    165\n"
            "B5      180        B8B10   100        B8      185\n"
            "B5B7    220        B10     120        B8B10   225\n"
            "B7      240                           B10     245\n");
}

TEST_F(WorkedExample, WaitsAreToldApartFromDriving) {
  const Plan after = bypassed(planned());
  const std::vector<Stay> stays = stays_of(after.charts[2]);
  EXPECT_EQ(stays[1].node, node(network_, "C8"));
  EXPECT_EQ(stays[1].arrival, 40 * kSecond);
  EXPECT_EQ(stays[1].departure, 145 * kSecond);
}

}  // namespace
}  // namespace rubicon::charts
