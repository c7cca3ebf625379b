#include "src/motion/guides/planners.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/unit/guides/guide_machines.hpp"

namespace rubicon::guides {
namespace {

using Q = std::vector<double>;

/// A wall across the square with a gap at the top, between start and goal.
bool in_wall(std::span<const double> q) { return q[0] > 4 && q[0] < 6 && q[1] < 8; }

/// Those of OMPL have tests of their own.
bool is_ours(GuideKind kind) { return !is_travel(kind) && kind != GuideKind::ompl; }

Search search(const robot::RobotModel& model, GuideSpec spec, MotionTests& tests, const Q& from,
              const Q& to, std::size_t* checks = nullptr) {
  const robot::Mounting mounting = test::standing(model);
  Space space(model, mounting, from, spec, tests);
  const Point start = space.point(from);
  const Point goal = space.point(to);
  PlanMemory memory;
  const auto find = [&]() -> Search {
    switch (spec.kind) {
      case GuideKind::rrt_connect:
        return connect_trees(space, start, goal, model, false);
      case GuideKind::astar:
        return search_lattice(space, start, goal);
      case GuideKind::prm:
        return search_roadmap(space, start, goal, memory.roadmap);
      case GuideKind::dstar_lite:
        return repair_lattice(space, start, goal, memory.lattice);
      case GuideKind::drrt:
        return search_tree(space, start, goal, memory.tree);
      default:
        return grow_to_goal(space, start, goal);
    }
  };
  Search found = find();
  if (checks) *checks = space.checks();
  return found;
}

GuideSpec spec_of(GuideKind kind, double seed) {
  GuideSpec spec = default_guide(kind);
  spec.seed = seed;
  spec.step = 5;  // half a metre
  return spec;
}

/// Above the middle: samples about a goal right behind the wall seldom pass over it.
const Q kGoal{9, 8};

TEST(Planners, AllFindTheWayOverTheWallAndKeepOutOfIt) {
  for (const KindInfo& info : guide_kinds()) {
    if (!is_ours(info.kind)) continue;
    for (double seed = 1; seed <= 10; ++seed) {
      test::PredicateTests tests(in_wall);
      const Search found = search(test::gantry(), spec_of(info.kind, seed), tests, {1, 1}, kGoal);
      ASSERT_FALSE(found.way.empty()) << info.name << " with seed " << seed;
      EXPECT_EQ(found.way.front(), (Point{1, 1}));
      EXPECT_EQ(found.way.back(), (Point{9, 8}));
      for (std::size_t i = 0; i + 1 < found.way.size(); ++i) {
        EXPECT_TRUE(tests.sweeps_free(found.way[i], found.way[i + 1])) << info.name;
      }
    }
  }
}

TEST(Planners, TheSameSeedGivesTheSameWayAndAnotherAnother) {
  for (const KindInfo& info : guide_kinds()) {
    if (!is_ours(info.kind)) continue;
    std::set<std::vector<Point>> ways;
    for (double seed = 1; seed <= 4; ++seed) {
      test::PredicateTests tests(in_wall);
      const GuideSpec spec = spec_of(info.kind, seed);
      const auto way = search(test::gantry(), spec, tests, {1, 1}, kGoal).way;
      EXPECT_EQ(way, search(test::gantry(), spec, tests, {1, 1}, kGoal).way);
      ways.insert(way);
    }
    if (info.kind == GuideKind::astar || info.kind == GuideKind::dstar_lite) {
      EXPECT_EQ(ways.size(), 1u);  // it draws nothing
    } else {
      EXPECT_GT(ways.size(), 1u) << info.name;
    }
  }
}

TEST(Planners, ConnectGoesStraightWhereNothingIsInTheWay) {
  test::PredicateTests tests([](std::span<const double>) { return false; });
  std::size_t checks = 0;
  const Search found =
      search(test::gantry(), spec_of(GuideKind::rrt_connect, 1), tests, {1, 1}, {9, 1}, &checks);
  EXPECT_EQ(found.way.size(), 2u);
  EXPECT_EQ(checks, 1u);
}

TEST(Planners, LimitsOfNodesAndChecksEndASearchWithoutAWay) {
  const auto closed = [](std::span<const double> q) { return q[0] > 4 && q[0] < 6; };
  for (const KindInfo& info : guide_kinds()) {
    if (!is_ours(info.kind)) continue;
    GuideSpec spec = spec_of(info.kind, 1);
    spec.nodes = 60;
    test::PredicateTests tests(closed);
    Search found = search(test::gantry(), spec, tests, {1, 1}, {9, 1});
    EXPECT_TRUE(found.way.empty());
    EXPECT_LE(found.nodes, 62u) << info.name;
    spec.nodes = 2000;
    spec.checks = 100;
    std::size_t checks = 0;
    found = search(test::gantry(), spec, tests, {1, 1}, {9, 1}, &checks);
    EXPECT_TRUE(found.way.empty());
    EXPECT_FALSE(found.out_of_nodes) << info.name;
    EXPECT_LE(checks, 110u) << info.name;
  }
}

TEST(Planners, AVehicleFindsItsWayRoundAWall) {
  const auto wall = [](std::span<const double> q) {
    return q[0] > 4 && q[0] < 6 && std::fabs(q[1]) < 8;
  };
  test::PredicateTests tests(wall);
  for (const GuideKind kind : {GuideKind::rrt_connect, GuideKind::rrt_plus}) {
    GuideSpec spec = default_guide(kind);
    spec.step = 20;
    const Search found = search(test::vehicle(), spec, tests, {0, 0, 0}, {10, 0, 90});
    EXPECT_FALSE(found.way.empty()) << name_of(kind);
  }
}

TEST(Planners, WhatIsKeptHoldsOnTheWholeWay) {
  // x + y = 10 within 1: the way over the wall at x = 5 stays on that band.
  const auto low_wall = [](std::span<const double> q) {
    return q[0] > 4.5 && q[0] < 5.5 && q[1] < 5.2;
  };
  for (const KindInfo& info : guide_kinds()) {
    if (!is_ours(info.kind)) continue;
    GuideSpec spec = spec_of(info.kind, 2);
    spec.keep = {{{{0, 1.0}, {1, 1.0}}, 11}, {{{0, -1.0}, {1, -1.0}}, -9}};
    test::PredicateTests tests(low_wall);
    const Search found = search(test::gantry(), spec, tests, {2, 8}, {8, 2});
    ASSERT_FALSE(found.way.empty()) << info.name;
    for (const Point& point : found.way) {
      EXPECT_NEAR(point[0] + point[1], 10, 1 + 1e-5) << info.name;
    }
  }
}

/// Langari 2015, 3.3.2: the mean of the samples is the goal, whatever their concentration.
TEST(Planners, SamplesGatherAboutTheGoal) {
  const robot::RobotModel model = test::gantry();
  const robot::Mounting mounting = test::standing(model);
  test::PredicateTests tests([](std::span<const double>) { return false; });
  const GuideSpec spec = default_guide(GuideKind::rrt_nonuniform);
  const Q start{0, 0};
  Space space(model, mounting, start, spec, tests);
  for (double concentration : {1.0, 5.0}) {
    for (double goal : {1.0, 3.0, 5.0, 9.0}) {
      Random random(11);
      double sum = 0;
      constexpr int kDraws = 50'000;
      for (int n = 0; n < kDraws; ++n) {
        sum += space.sample_about(Point{goal, goal}, concentration, random)[0];
      }
      EXPECT_NEAR(sum / kDraws, goal, 0.05);
    }
  }
}

TEST(Planners, AWayIsMadeShorterByShortcuts) {
  test::PredicateTests tests(in_wall);
  const robot::RobotModel model = test::gantry();
  const auto time = [&](double improve) {
    GuideSpec spec = spec_of(GuideKind::rrt_connect, 5);
    spec.improve = improve;
    const Leg leg(model, test::standing(model));
    const std::vector<Point> way = search(model, spec, tests, {1, 1}, {9, 1}).way;
    double sum = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      sum += std::max(std::fabs(way[i + 1][0] - way[i][0]), std::fabs(way[i + 1][1] - way[i][1]));
    }
    return sum;
  };
  // Up 7, over the wall 2, down 7 at least; each parameter a metre a second.
  EXPECT_GE(time(0), 16 - 1e-9);
  EXPECT_LE(time(500), time(0));
  EXPECT_LT(time(500), 16.5);
}

}  // namespace
}  // namespace rubicon::guides
