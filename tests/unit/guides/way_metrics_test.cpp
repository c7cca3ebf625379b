#include "src/motion/guides/way_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/guides/guide_machines.hpp"

namespace rubicon::guides {
namespace {

using Q = std::vector<double>;

WayMetrics metrics(const robot::RobotModel& model, const std::vector<Q>& way) {
  return way_metrics(model, test::standing(model), way, false);
}

TEST(WayMetrics, AStraightWayIsNotRoughHoweverItIsCut) {
  const WayMetrics whole = metrics(test::gantry(), {{0, 0}, {8, 4}});
  const WayMetrics cut = metrics(test::gantry(), {{0, 0}, {2, 1}, {2, 1}, {6, 3}, {8, 4}});
  EXPECT_EQ(whole.roughness, 0);
  EXPECT_NEAR(cut.roughness, 0, 1e-12);
  EXPECT_NEAR(whole.motion_time, 8, 1e-12);
  EXPECT_NEAR(cut.motion_time, 8, 1e-12);
  EXPECT_NEAR(whole.length, 12, 1e-9);  // a sum over the parameters
}

TEST(WayMetrics, ARightAngleOfTwoParametersCountsTwo) {
  EXPECT_NEAR(metrics(test::gantry(), {{0, 0}, {5, 0}, {5, 5}}).roughness, 2, 1e-12);
}

TEST(WayMetrics, SpeedsAreThoseOfTheThesis) {
  const robot::RobotModel model = test::excavator();
  EXPECT_NEAR(metrics(model, {{0, 0, 100, 100}, {150, 0, 100, 100}}).motion_time, 10, 1e-12);
  // PLANNERS 8.8: 10 degrees of the boom with 10 of the stick
  EXPECT_NEAR(metrics(model, {{0, 0, 100, 100}, {0, 10, 110, 100}}).motion_time, 10 / 5.5, 1e-12);
}

TEST(WayMetrics, AVehicleTakesTheSameTimeInAllDirections) {
  // 1 m/s and 20 degrees a second: it turns to face the place, drives there and turns back.
  const robot::RobotModel model = test::vehicle();
  EXPECT_NEAR(metrics(model, {{0, 0, 0}, {5, 0, 0}}).motion_time, 5, 1e-9);
  EXPECT_NEAR(metrics(model, {{0, 0, 90}, {0, 5, 90}}).motion_time, 5, 1e-9);
  EXPECT_NEAR(metrics(model, {{0, 0, 0}, {0, 5, 0}}).motion_time, 5 + 2 * 90 / 20.0, 1e-9);
  EXPECT_NEAR(metrics(model, {{1, 1, 45}, {4, 4, 45}}).motion_time, std::sqrt(18), 1e-9);
}

/// The effective arms of Langari's appendix A, by the law of cosines.
TEST(WayMetrics, LengthIsTheSumOfArmsTimesAngles) {
  const robot::RobotModel model = test::excavator();
  const Q from{20, 30, 95, 130};
  const double l1 = 5.648;
  const double l2 = 2.889;
  const double l3 = 1.562;
  const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
  const double stick = radians(from[2]);
  const double bucket = radians(from[3]);
  const double r3 = std::sqrt(l3 * l3 + l2 * l2 - 2 * l3 * l2 * std::cos(bucket));
  const double inner = stick - std::atan2(l3 * std::sin(bucket), l2 - l3 * std::cos(bucket));
  const double r2 = std::sqrt(l1 * l1 + r3 * r3 - 2 * r3 * l1 * std::cos(inner));
  const double off = std::atan2(r3 * std::sin(inner), l1 - r3 * std::cos(inner));
  const double r1 = r2 * std::cos(radians(from[1]) - off) + 0.228;
  const double arms[] = {r1, r2, r3, l3};
  for (std::size_t i = 0; i < 4; ++i) {
    Q to = from;
    to[i] += 1;
    EXPECT_NEAR(metrics(model, {from, to}).length, arms[i] * radians(1), 1e-8) << i;
  }
}

}  // namespace
}  // namespace rubicon::guides
