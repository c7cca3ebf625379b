#include "src/motion/guides/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>

#include "src/motion/guides/planners.hpp"
#include "src/motion/math/random.hpp"
#include "tests/unit/guides/guide_machines.hpp"

namespace rubicon::guides {
namespace {

using Q = std::vector<double>;

/// Squares of the plane in which nothing may be.
struct Boxes {
  std::vector<std::array<double, 4>> all;

  bool operator()(std::span<const double> q) const {
    return std::any_of(all.begin(), all.end(), [&](const std::array<double, 4>& box) {
      return q[0] > box[0] && q[0] < box[2] && q[1] > box[1] && q[1] < box[3];
    });
  }
};

Boxes random_boxes(Random& random, std::size_t count) {
  Boxes boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.between(0, 9);
    const double y = random.between(0, 9);
    boxes.all.push_back({x, y, x + random.between(0.3, 3), y + random.between(0.3, 3)});
  }
  return boxes;
}

GuideSpec astar(Neighbours neighbours, double safety) {
  GuideSpec spec = default_guide(GuideKind::astar);
  spec.step = 10;  // a metre
  spec.neighbours = neighbours;
  spec.safety = safety;
  return spec;
}

Search search(const GuideSpec& spec, MotionTests& tests, const Q& from, const Q& to,
              const robot::RobotModel& model = test::gantry()) {
  const robot::Mounting mounting = test::standing(model);
  Space space(model, mounting, from, spec, tests);
  return search_lattice(space, space.point(from), space.point(to));
}

/// The least cost from start to goal of the gantry, by Dijkstra over the whole lattice, every leg
/// tested first; infinite: there is no way. Written without anything of the lattice.
double least_cost(const GuideSpec& spec, MotionTests& tests, const Q& from, const Q& to) {
  std::vector<Q> points{from};
  for (double x = to[0] - std::floor(to[0]); x <= 10; ++x) {
    for (double y = to[1] - std::floor(to[1]); y <= 10; ++y) points.push_back({x, y});
  }
  const auto next_to = [&](const Q& a, const Q& b) {
    const double dx = std::fabs(a[0] - b[0]);
    const double dy = std::fabs(a[1] - b[1]);
    if (a == from) return dx < 2 - 1e-9 && dy < 2 - 1e-9;
    const double most = std::max(dx, dy);
    if (most < 0.5 || most > 1.5) return false;
    return spec.neighbours == Neighbours::all || std::min(dx, dy) < 0.5;
  };
  const auto blocked_share = [&](const Q& q) {
    double blocked = 0;
    double count = 0;
    for (const Q& by : {Q{1, 0}, Q{-1, 0}, Q{0, 1}, Q{0, -1}}) {
      const Q beside{q[0] + by[0], q[1] + by[1]};
      if (std::min(beside[0], beside[1]) < 0 || std::max(beside[0], beside[1]) > 10) continue;
      ++count;
      if (!tests.stands(beside)) ++blocked;
    }
    return blocked / count;
  };
  std::vector<double> cost(points.size(), std::numeric_limits<double>::infinity());
  std::set<std::pair<double, std::size_t>> open{{0, 0}};
  cost[0] = 0;
  while (!open.empty()) {
    const std::size_t here = open.begin()->second;
    open.erase(open.begin());
    if (here > 0 &&
        std::fabs(points[here][0] - to[0]) + std::fabs(points[here][1] - to[1]) < 1e-9) {
      return cost[here];
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (!next_to(points[here], points[i]) || !tests.sweeps_free(points[here], points[i]))
        continue;
      const double length =
          10 * std::hypot(points[i][0] - points[here][0], points[i][1] - points[here][1]);
      const double there = cost[here] + length * (1 + spec.safety * blocked_share(points[i]));
      if (there >= cost[i]) continue;
      open.erase({cost[i], i});
      cost[i] = there;
      open.emplace(there, i);
    }
  }
  return std::numeric_limits<double>::infinity();
}

TEST(Astar, CostsAsMuchAsDijkstraFinds) {
  Random random(1995);
  int found = 0;
  int none = 0;
  for (int n = 0; n < 60; ++n) {
    test::PredicateTests tests(random_boxes(random, 1 + random.index(30)));
    const Q from{random.between(0, 10), random.between(0, 10)};
    const Q to{random.between(0, 10), random.between(0, 10)};
    if (!tests.stands(from) || !tests.stands(to)) continue;
    for (const Neighbours neighbours : {Neighbours::straight, Neighbours::all}) {
      for (const double safety : {0.0, 3.0}) {
        GuideSpec spec = astar(neighbours, safety);
        const double least = least_cost(spec, tests, from, to);
        for (const Heuristic heuristic : {Heuristic::fitting, Heuristic::euclid}) {
          spec.heuristic = heuristic;
          const Search way = search(spec, tests, from, to);
          // Without safety it may go straight, which no lattice does.
          if (safety == 0 && tests.sweeps_free(from, to)) {
            EXPECT_EQ(way.way.size(), 2u);
            continue;
          }
          ASSERT_EQ(way.way.empty(), !std::isfinite(least)) << n;
          (way.way.empty() ? none : found) += 1;
          if (way.way.empty()) continue;
          EXPECT_NEAR(way.cost, least, 1e-6) << n;
        }
      }
    }
  }
  EXPECT_GT(found, 80);
  EXPECT_GT(none, 5);
}

TEST(Astar, LegsAreFreeAndJoinStartAndGoal) {
  Random random(7);
  for (int n = 0; n < 40; ++n) {
    test::PredicateTests tests(random_boxes(random, 6));
    const Q from{random.between(0, 10), random.between(0, 10)};
    const Q to{random.between(0, 10), random.between(0, 10)};
    if (!tests.stands(from) || !tests.stands(to)) continue;
    const std::vector<Point> way = search(astar(Neighbours::all, 0), tests, from, to).way;
    if (way.empty()) continue;
    EXPECT_EQ(way.front(), from);
    EXPECT_EQ(way.back(), to);
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
      EXPECT_TRUE(tests.sweeps_free(way[i], way[i + 1]));
  }
}

TEST(Astar, SafetyKeepsAwayFromWhatIsInTheWay) {
  // The short way leads along the box, the safe one a metre away from it.
  test::PredicateTests tests(Boxes{{{2.5, 2.5, 7.5, 5.5}}});
  const auto nearest = [&](double safety) {
    double gap = 10;
    for (const Point& p : search(astar(Neighbours::all, safety), tests, {1, 4}, {9, 4}).way) {
      if (p[0] > 2.5 && p[0] < 7.5) gap = std::min(gap, std::max(2.5 - p[1], p[1] - 5.5));
    }
    return gap;
  };
  EXPECT_LE(nearest(0), 0.5 + 1e-9);
  EXPECT_GE(nearest(5), 1.5 - 1e-9);
}

TEST(Astar, ACyclicAngleGoesTheShortWayRound) {
  test::PredicateTests tests([](std::span<const double> q) { return std::fabs(q[0]) < 20; });
  GuideSpec spec = default_guide(GuideKind::astar);
  spec.over = {0, 1};
  const Search way =
      search(spec, tests, {-100, 0, 100, 100}, {100, 30, 100, 100}, test::excavator());
  ASSERT_FALSE(way.way.empty());
  for (const Point& point : way.way) EXPECT_GT(std::fabs(point[0]), 99);
}

TEST(Astar, WhatItDoesNotSpanChangesInTheLastLeg) {
  test::PredicateTests tests(
      [](std::span<const double> q) { return q[0] > 30 && q[0] < 60 && q[1] < 20; });
  GuideSpec spec = default_guide(GuideKind::astar);
  spec.over = {0, 1};
  const Search way = search(spec, tests, {0, 0, 100, 100}, {90, 0, 120, 90}, test::excavator());
  ASSERT_GE(way.way.size(), 3u);
  for (std::size_t i = 0; i + 1 < way.way.size(); ++i) {
    EXPECT_EQ(way.way[i][2], 100);
    EXPECT_EQ(way.way[i][3], 100);
  }
  EXPECT_EQ(way.way.back(), (Point{90, 0, 120, 90}));
}

TEST(Astar, AVehicleFacesTheWayItHasCome) {
  const Boxes walls{{{3, -8, 4, 8}, {-6, 7, 4, 8}}};
  test::PredicateTests tests(walls);
  const robot::RobotModel model = test::vehicle();
  for (const Neighbours neighbours : {Neighbours::straight, Neighbours::all}) {
    const Search way = search(astar(neighbours, 0), tests, {0.2, 0.1, 15}, {8, 0, 90}, model);
    ASSERT_GE(way.way.size(), 4u);
    EXPECT_EQ(way.way.back(), (Point{8, 0, 90}));
    for (std::size_t i = 1; i + 2 < way.way.size(); ++i) {
      const Point& a = way.way[i];
      const Point& b = way.way[i + 1];
      const double heading = std::atan2(b[1] - a[1], b[0] - a[0]) * 180 / 3.14159265358979;
      EXPECT_NEAR(std::remainder(b[2] - heading, 360), 0, 1e-6);
    }
  }
}

/// The octile estimate is the cost of the way where nothing is in the way, whatever the pitches.
TEST(Lattice, TheEstimateThatFitsIsTheTruthWhereNothingIsInTheWay) {
  const robot::RobotModel model = test::excavator();
  const robot::Mounting mounting = test::standing(model);
  test::PredicateTests tests([](std::span<const double>) { return false; });
  for (const Neighbours neighbours : {Neighbours::straight, Neighbours::all}) {
    GuideSpec spec = astar(neighbours, 0);
    spec.weights = {{0, 0.7}, {2, 1.6}};
    spec.over = {0, 1, 2};
    const Q goal{0, 10, 100, 100};
    Space space(model, mounting, goal, spec, tests);
    const Lattice lattice(space, goal, goal);
    std::map<Lattice::Node, double> cost{{{}, 0}};
    std::set<std::pair<double, Lattice::Node>> open{{0, {}}};
    for (int n = 0; n < 300; ++n) {
      const auto [there, node] = *open.begin();
      open.erase(open.begin());
      EXPECT_NEAR(lattice.left(node), there, 1e-9);
      for (const Lattice::Node& next : lattice.next_to(node)) {
        const double far = there + space.distance(lattice.point(node), lattice.point(next));
        const auto known = cost.find(next);
        if (known != cost.end() && known->second <= far) continue;
        if (known != cost.end()) open.erase({known->second, next});
        cost[next] = far;
        open.emplace(far, next);
      }
    }
  }
}

}  // namespace
}  // namespace rubicon::guides
