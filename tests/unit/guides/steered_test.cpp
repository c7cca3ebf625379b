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
  if (kind == GuideKind::drrt) spec.step = 20;
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
  for (const GuideKind kind :
       {GuideKind::rrt, GuideKind::rrt_nonuniform, GuideKind::rrt_plus, GuideKind::drrt}) {
    const PlanReport report =
        plan(model, kind, 4, {0, 0, 0}, {4, 2, 60}, [](std::span<const double>) { return false; });
    ASSERT_TRUE(report.found()) << name_of(kind);
    expect_chords(report.way);
  }
}

/// A range of 30 m by 11 m, so that random places are dense enough.
robot::RobotModel in_the_lane(robot::RobotModel model) {
  model.parameters[0].lower = -15;
  model.parameters[0].upper = 15;
  model.parameters[1].lower = -5;
  model.parameters[1].upper = 6;
  return model;
}

TEST(Steered, ATruckParks) {
  const Q from{-9, 3, 0};
  const Q to{0, -3.5, 90};
  for (const bool chords : {true, false}) {
    const robot::RobotModel any = chords ? test::steered_vehicle() : test::vehicle();
    const robot::RobotModel narrow = in_the_lane(any);
    for (const GuideKind kind : {GuideKind::astar, GuideKind::rrt_connect, GuideKind::drrt}) {
      if (!chords && kind != GuideKind::rrt_connect) continue;
      const PlanReport report =
          plan(kind == GuideKind::drrt ? narrow : any, kind, 2, from, to, outside_lane_and_bay);
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

/// The roadmap joins each place to those that the shortest ways lead to, found without looking for
/// all ways; a way that is blocked then is gone round by what is kept.
TEST(Steered, ARoadmapOfArcsIsKeptWhileThingsComeAndGo) {
  const robot::RobotModel model = in_the_lane(test::steered_vehicle());
  const robot::Mounting mounting = test::standing(model);
  GuideSpec spec = default_guide(GuideKind::prm);
  spec.nodes = 120;
  spec.nearest = 6;
  spec.turn_radius = kRadius;
  const Q from{-9, 3, 0};
  const Q to{9, 2, 0};
  test::PredicateTests open([](std::span<const double>) { return false; });
  Space space(model, mounting, from, spec, open);
  RoadmapMemory memory;
  ASSERT_FALSE(search_roadmap(space, from, to, memory).way.empty());
  const Roadmap& roadmap = *memory.roadmap;
  for (std::size_t i = 0; i < roadmap.points.size(); i += 7) {
    std::vector<double> all;
    for (std::size_t k = 0; k < roadmap.points.size(); ++k) {
      if (k != i) all.push_back(space.distance(roadmap.points[k], roadmap.points[i]));
    }
    std::sort(all.begin(), all.end());
    std::size_t nearest = 0;
    for (const int k : roadmap.next_to[i]) {
      const Point& there = roadmap.points[static_cast<std::size_t>(k)];
      if (space.distance(there, roadmap.points[i]) <= all[5] + 1e-9) ++nearest;
    }
    EXPECT_EQ(nearest, 6u) << i;
  }
  test::PredicateTests pillar(
      [](std::span<const double> q) { return std::hypot(q[0] - 0, q[1] - 2.5) < 1.2; });
  Space changed(model, mounting, from, spec, pillar);
  const Search round = search_roadmap(changed, from, to, memory);
  ASSERT_FALSE(round.way.empty());
  for (std::size_t k = 0; k + 1 < round.way.size(); ++k) {
    EXPECT_TRUE(changed.leg_is_free(round.way[k], round.way[k + 1]));
  }
  expect_chords(changed.with_chords(round.way));
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
