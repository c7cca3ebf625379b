#include "src/simulation/site/load_chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "src/motion/math/angles.hpp"

namespace rubicon::site {
namespace {

using Chart = std::vector<robot::CapacityPoint>;
using geometry::ScrewMotion;

/// A tool that turns about the vertical through `centre` from one heading to another.
geometry::Motion turning(const math::Vec3& centre, double radius, double from_deg, double to_deg) {
  ScrewMotion motion;
  motion.point = centre;
  motion.angle_deg = to_deg - from_deg;
  motion.X0.translation() =
      centre + radius * math::Vec3(math::cos_deg(from_deg), math::sin_deg(from_deg), 0);
  return {motion};
}

geometry::Motion straight(double from, double to) {
  math::Pose X = math::Pose::Identity();
  X.translation().x() = from;
  return geometry::translating(X, {to - from, 0, 0});
}

bool allows(const Chart& chart, double mass, const geometry::Motion& motion) {
  return allows_step(chart, mass, math::Pose::Identity(), motion);
}

TEST(LoadChart, IsJudgedAllAlongAStep) {
  // The tool swings from 17.3 m over 20 m to 17.3 m.
  const Chart chart = {{10, 5000}, {19, 500}};
  const geometry::Motion swing = turning({10, 0, 0}, 10, 60, -60);
  EXPECT_FALSE(allows(chart, 1000, swing));
  EXPECT_FALSE(allows(chart, 400, swing));
  EXPECT_TRUE(allows({{10, 5000}, {20, 500}}, 500, swing));
  EXPECT_FALSE(allows({{10, 5000}, {20, 500}}, 501, swing));
}

TEST(LoadChart, ALoadAtItsLimitTurns) {
  const Chart chart = {{10, 5000}, {30, 1000}};
  const geometry::Motion turn = turning({0, 0, 0}, 20.0 / 3, 10, 170);
  EXPECT_TRUE(allows(chart, 5000, turn));
  const double radius = 55.0 / 3;
  EXPECT_TRUE(allows(chart, capacity_at(chart, radius), turning({0, 0, 0}, radius, 10, 170)));
  EXPECT_FALSE(allows(chart, capacity_at(chart, radius), straight(radius, radius + 0.001)));
}

TEST(LoadChart, ALoadAtItsLimitHangsAndMovesHoweverItsRadiusIsRounded) {
  const Chart chart = {{5, 1000}, {10, 5000}, {30, 3000}};
  const double beyond = std::nextafter(30.0, 31.0);
  // What the chart allows a micrometre nearer in: 0.1 g more.
  EXPECT_NEAR(capacity_near(chart, beyond), 3000, 2e-4);
  EXPECT_TRUE(may_hang(chart, 3000, beyond));
  EXPECT_TRUE(may_hang(chart, std::nextafter(3000.0, 3001.0), 30));
  EXPECT_FALSE(may_hang(chart, 3000.001, 30));
  EXPECT_FALSE(may_hang(chart, 3000, 30.00001));
  EXPECT_TRUE(allows(chart, 3000, straight(20, beyond)));
  EXPECT_TRUE(allows(chart, 3000, straight(beyond, 20)));
  EXPECT_FALSE(allows(chart, 3000, straight(beyond, 7)));
  EXPECT_FALSE(allows(chart, 3000, straight(20, 30.00001)));
}

TEST(LoadChart, MayAllowLessNearerIn) {
  const Chart chart = {{5, 1000}, {10, 5000}, {30, 3000}};
  EXPECT_TRUE(allows(chart, 2500, straight(12, 7)));
  EXPECT_FALSE(allows(chart, 2500, straight(12, 6)));
  EXPECT_FALSE(allows(chart, 2500, straight(12, -12)));
}

TEST(LoadChart, ATooHeavyLoadMayGoWhereMoreIsAllowed) {
  const Chart chart = {{10, 5000}, {20, 1000}};
  EXPECT_TRUE(allows(chart, 3000, straight(18, 16)));
  EXPECT_TRUE(allows(chart, 3000, straight(25, 24)));
  EXPECT_FALSE(allows(chart, 3000, straight(16, 18)));
  EXPECT_FALSE(allows(chart, 3000, straight(24, 25)));
}

TEST(LoadChart, AgreesWithManyMomentsOfRandomSteps) {
  std::mt19937 random(5);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  int allowed = 0;
  int barred = 0;
  for (int i = 0; i < 20000; ++i) {
    Chart chart;
    double radius = between(2, 6);
    for (int point = 0; point < 4; ++point) {
      chart.push_back({radius, between(500, 4000)});
      radius += between(1, 8);
    }
    const double mass = between(200, 2500);
    const double aside = between(0, 12);
    const double from_deg = between(-180, 180);
    const double way_deg = between(-90, 90);
    const geometry::Motion motion =
        turning({aside, 0, 0}, between(1, 12), from_deg, from_deg + way_deg);
    const auto capacity = [&](double s) {
      return capacity_at(chart, chart_radius(math::Pose::Identity(), motion.pose(s).translation()));
    };
    if (capacity(0) < mass) continue;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 2000; ++k) least = std::min(least, capacity(k / 2000.0));
    // Steeper than 4000 kg/m no chart is here but at its end, and 1 mm is 4 kg.
    if (std::fabs(least - mass) < 8) continue;
    const bool found = allows(chart, mass, motion);
    (found ? allowed : barred) += 1;
    EXPECT_EQ(found, least >= mass) << i;
  }
  EXPECT_GT(allowed, 1000);
  EXPECT_GT(barred, 1000);
}

}  // namespace
}  // namespace rubicon::site
