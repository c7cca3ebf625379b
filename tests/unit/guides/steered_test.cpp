#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "src/motion/guides/guide.hpp"
#include "src/motion/guides/planners.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/random.hpp"
#include "src/motion/math/turns.hpp"
#include "src/motion/robot/turns.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/guides/guide_machines.hpp"

namespace rubicon::guides {
namespace {

using Q = std::vector<double>;
constexpr double kRadius = 2.5;

/// A truck of 4 m by 1.6 m, its rear axle a metre from its end, in a lane with a bay in one of its
/// sides.
bool outside_lane_and_bay(std::span<const double> q) {
  for (const double along : {-1.0, 0.0, 1.0, 2.0, 3.0}) {
    for (const double across : {-0.8, 0.8}) {
      const double x = q[0] + along * math::cos_deg(q[2]) - across * math::sin_deg(q[2]);
      const double y = q[1] + along * math::sin_deg(q[2]) + across * math::cos_deg(q[2]);
      const bool lane = y >= 0 && y <= 6 && std::fabs(x) <= 15;
      const bool bay = y > -5 && y <= 0 && std::fabs(x) <= 1.3;
      if (!lane && !bay) return true;
    }
  }
  return false;
}

PlanReport plan(const robot::RobotModel& model, GuideKind kind, double seed, const Q& from,
                const Q& to, std::function<bool(std::span<const double>)> blocked) {
  test::PredicateTests tests(std::move(blocked));
  GuideSpec spec = default_guide(kind);
  spec.seed = seed;
  spec.turn_radius = kRadius;
  spec.improve = 20;
  if (kind != GuideKind::astar && kind != GuideKind::rrt_connect) spec.goal_bias = 0.3;
  if (kind == GuideKind::astar) spec.step = 8;
  GuideTask task;
  task.model = &model;
  task.mounting = test::standing(model);
  task.goals = {to};
  return plan_way(spec, task, from, tests);
}

void expect_chords(const std::vector<Q>& way) {
  for (std::size_t k = 1; k < way.size(); ++k) {
    const double dx = way[k][0] - way[k - 1][0];
    const double dy = way[k][1] - way[k - 1][1];
    const double turned = math::normalised_deg(way[k][2] - way[k - 1][2]);
    const double mean = way[k - 1][2] + turned / 2;
    EXPECT_NEAR(dx * math::sin_deg(mean) - dy * math::cos_deg(mean), 0, 1e-8);
    const double chord = std::sqrt(dx * dx + dy * dy);
    EXPECT_GE(chord, 2 * kRadius * math::sin_deg(std::fabs(turned) / 2) - 1e-8);
  }
}

TEST(Steered, AFreeWayIsThatOfReedsAndShepp) {
  const robot::RobotModel model = test::steered_vehicle();
  math::Random random(3);
  for (int i = 0; i < 30; ++i) {
    Q to{random.between(-8, 8), 0, 0};
    to[1] = random.between(-8, 8);
    to[2] = random.between(-180, 180);
    const PlanReport report = plan(model, GuideKind::astar, 1, {0, 0, 0}, to,
                                   [](std::span<const double>) { return false; });
    ASSERT_TRUE(report.found());
    expect_chords(report.way);
    // Its steps are driven at 1 m/s where it does not have to turn faster than 20 degrees a second.
    const double shortest = reeds_shepp_way({0, 0, 0}, {to[0], to[1], to[2]}, kRadius).length();
    EXPECT_GE(report.metrics.motion_time, shortest * 0.99);
  }
}

TEST(Steered, TheThesisKindsGrowArcs) {
  const robot::RobotModel model = test::steered_vehicle();
  for (const GuideKind kind : {GuideKind::rrt, GuideKind::rrt_nonuniform, GuideKind::rrt_plus}) {
    const PlanReport report =
        plan(model, kind, 4, {0, 0, 0}, {4, 2, 60}, [](std::span<const double>) { return false; });
    ASSERT_TRUE(report.found()) << name_of(kind);
    expect_chords(report.way);
  }
}

TEST(Steered, ATruckParks) {
  const Q from{-9, 3, 0};
  const Q to{0, -3.5, 90};
  for (const bool chords : {true, false}) {
    const robot::RobotModel model = chords ? test::steered_vehicle() : test::vehicle();
    for (const GuideKind kind : {GuideKind::astar, GuideKind::rrt_connect}) {
      if (!chords && kind == GuideKind::astar) continue;
      const PlanReport report = plan(model, kind, 2, from, to, outside_lane_and_bay);
      ASSERT_TRUE(report.found()) << name_of(kind) << ' ' << report.checks;
      expect_chords(report.way);
      EXPECT_NEAR(report.way.back()[1], to[1], 1e-6);
      bool back = false;
      for (std::size_t k = 1; k < report.way.size(); ++k) {
        const double ahead =
            (report.way[k][0] - report.way[k - 1][0]) * math::cos_deg(report.way[k][2]) +
            (report.way[k][1] - report.way[k - 1][1]) * math::sin_deg(report.way[k][2]);
        back = back || ahead < -1e-6;
      }
      EXPECT_TRUE(back)
          << "it cannot come out of the lane into the bay tail first without going back";
    }
  }
}

TEST(Steered, StepsLeadThroughTheStopsOfALeg) {
  math::Random random(11);
  for (const bool chords : {true, false}) {
    const robot::RobotModel model = chords ? test::steered_vehicle() : test::vehicle();
    const robot::Mounting mounting = test::standing(model);
    const Leg leg(model, mounting, {}, kRadius);
    ASSERT_TRUE(leg.refusal().empty()) << leg.refusal();
    for (int i = 0; i < test::cases(60); ++i) {
      Q q{0, 0, random.between(-180, 180)};
      Q to{random.between(-9, 9), 0, 0};
      to[1] = random.between(-9, 9);
      to[2] = random.between(-180, 180);
      const std::vector<Q> stops = leg.stops(q, to);
      int moves = 0;
      Q steps(3);
      Q next(3);
      for (Q stop : stops) {
        robot::normalise(model, stop);
        while (leg.next_step(q, stop, steps) && moves < 2000) {
          EXPECT_LE(std::fabs(steps[0]), 0.5 + 1e-9);
          EXPECT_LE(std::fabs(steps[2]), 10 + 1e-9);
          // A vehicle that turns while it drives never turns on the spot.
          if (chords) {
            EXPECT_NE(steps[0], 0);
          }
          robot::apply_rules(model, mounting, q, steps, next);
          robot::normalise(model, next);
          q = next;
          ++moves;
        }
      }
      EXPECT_LT(moves, 2000);
      EXPECT_NEAR(q[0], to[0], 1e-6);
      EXPECT_NEAR(q[1], to[1], 1e-6);
      EXPECT_NEAR(math::normalised_deg(q[2] - to[2]), 0, 1e-6);
    }
  }
}

}  // namespace
}  // namespace rubicon::guides
