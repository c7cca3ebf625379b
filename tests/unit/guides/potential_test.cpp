#include "src/motion/guides/potential.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "src/motion/guides/guide.hpp"
#include "src/motion/math/random.hpp"
#include "tests/unit/guides/guide_machines.hpp"

namespace rubicon::guides {
namespace {

using Q = std::vector<double>;
using Cell = std::pair<int, int>;

/// A point among rectangles, numbered.
class Yard : public test::PredicateTests {
 public:
  explicit Yard(std::vector<std::array<double, 4>> boxes)
      : PredicateTests([this](std::span<const double> q) { return distance(q, nullptr) <= 0; }),
        boxes_(std::move(boxes)) {}

  Nearness nearest(std::span<const double> q, double range, const PairsLeftOut& left_out) override {
    Nearness near{std::numeric_limits<double>::infinity(), "trolley", ""};
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const std::string name = "box_" + std::to_string(i);
      const bool out =
          std::find(left_out.begin(), left_out.end(),
                    std::pair<std::string, std::string>("trolley", name)) != left_out.end();
      const double d = std::max(to_box(q, boxes_[i]), 0.0);
      if (out || d > range || d >= near.distance) continue;
      near.distance = d;
      near.met = name;
    }
    return near;
  }

  /// m to the nearest rectangle; in it 0 or less.
  double distance(std::span<const double> q, int* which) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (to_box(q, boxes_[i]) >= least) continue;
      least = to_box(q, boxes_[i]);
      if (which != nullptr) *which = static_cast<int>(i);
    }
    return least;
  }

 private:
  static double to_box(std::span<const double> q, const std::array<double, 4>& box) {
    const double dx = std::max({box[0] - q[0], q[0] - box[2], 0.0});
    const double dy = std::max({box[1] - q[1], q[1] - box[3], 0.0});
    return std::sqrt(dx * dx + dy * dy);
  }

  std::vector<std::array<double, 4>> boxes_;
};

GuideSpec potential(double repulsion, double influence) {
  GuideSpec spec = default_guide(GuideKind::potential);
  spec.repulsion = repulsion;
  spec.influence = influence;
  return spec;
}

/// Minima of the field over the plane of the gantry, metre by metre, by its formula alone.
std::set<Cell> brute_force_minima(Yard& yard, const GuideSpec& spec, const Q& goal) {
  const auto value = [&](int x, int y) {
    const Q q{static_cast<double>(x), static_cast<double>(y)};
    const double r = yard.distance(q, nullptr);
    if (r <= 0) return std::numeric_limits<double>::infinity();
    const double d = 10 * std::hypot(q[0] - goal[0], q[1] - goal[1]);
    const double push = r < spec.influence ? 1 / r - 1 / spec.influence : 0;
    return 0.5 * d * d * (spec.attraction + spec.repulsion * push * push);
  };
  std::set<Cell> minima;
  for (int x = 0; x <= 10; ++x) {
    for (int y = 0; y <= 10; ++y) {
      const double here = value(x, y);
      if (!std::isfinite(here)) continue;
      bool lowest = true;
      for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
          if (x + i < 0 || x + i > 10 || y + j < 0 || y + j > 10) continue;
          const Q from{static_cast<double>(x), static_cast<double>(y)};
          const Q to{static_cast<double>(x + i), static_cast<double>(y + j)};
          if (value(x + i, y + j) < here && yard.sweeps_free(from, to)) lowest = false;
        }
      }
      if (lowest) minima.insert({x, y});
    }
  }
  return minima;
}

TEST(Potential, ItsMinimaAreThoseOfAGrid) {
  math::Random random(17);
  const robot::RobotModel model = test::gantry();
  const robot::Mounting mounting = test::standing(model);
  int traps = 0;
  int clear = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<std::array<double, 4>> boxes;
    for (int i = 0; i < 4; ++i) {
      const double x = random.between(0.2, 8);
      const double y = random.between(0.2, 8);
      const double right = x + random.between(0.4, 4);
      boxes.push_back({x, y, right, y + random.between(0.4, 4)});
    }
    Yard yard(boxes);
    const Q start{0, 0};
    const Q goal{10, 10};
    if (yard.distance(start, nullptr) <= 0.01 || yard.distance(goal, nullptr) <= 0.01) continue;
    const GuideSpec spec = potential(random.between(0, 2), random.between(0.5, 3));
    const std::set<Cell> expected = brute_force_minima(yard, spec, goal);
    Space space(model, mounting, start, spec, yard);
    FieldOnLattice field(space, start, goal);
    std::set<Cell> minima;
    for (int x = 0; x <= 10; ++x) {
      for (int y = 0; y <= 10; ++y) {
        Lattice::Node node;
        node.pitches = {x - 10, y - 10};
        if (!std::isfinite(field.value(node))) continue;
        int steps = 0;
        for (auto next = field.below(node); next && steps < 1000; next = field.below(node)) {
          node = *next;
          ++steps;
        }
        EXPECT_LT(steps, 1000);
        minima.insert({10 + node.pitches[0], 10 + node.pitches[1]});
      }
    }
    EXPECT_EQ(minima, expected);
    (minima.size() > 1 ? traps : clear) += 1;
  }
  EXPECT_GT(traps, 5);
  EXPECT_GT(clear, 0);
}

PlanReport planned(Yard& yard, const GuideSpec& spec, const Q& from, const Q& to) {
  const robot::RobotModel model = test::gantry();
  GuideTask task;
  task.model = &model;
  task.mounting = test::standing(model);
  task.goals = {to};
  return plan_way(spec, task, from, yard);
}

TEST(Potential, ATrapIsNamedWithWhatIsNearest) {
  Yard yard({{4, 1, 5, 9}, {2, 8.5, 4.5, 9}, {2, 1, 4.5, 1.5}});
  const PlanReport report = planned(yard, potential(0.5, 1), {1, 5}, {9, 5});
  EXPECT_EQ(report.outcome, PlanReport::Outcome::no_way);
  EXPECT_EQ(report.cause,
            "the field has a minimum at x 3, y 5, where trolley is 1.00 m from box_0");
}

TEST(Potential, WhatTouchesAtTheGoalDoesNotRepel) {
  // The goal lies on the edge of a box, and the way to it along another one.
  Yard yard({{5, 0, 6, 4}});
  const Q goal{4.9995, 2};
  const PlanReport report = planned(yard, potential(5, 3), {0.9995, 2}, goal);
  ASSERT_TRUE(report.found()) << report.cause;
  EXPECT_EQ(report.way.size(), 2u) << "nothing pushes it aside";
}

TEST(Potential, ItKeepsAwayFromWhatIsNear) {
  Yard yard({{3, 0, 6, 4.6}});
  const auto least = [&](const PlanReport& report) {
    double nearest = 1e9;
    for (std::size_t k = 0; k + 1 < report.way.size(); ++k) {
      for (int i = 0; i <= 100; ++i) {
        Q q(2);
        for (std::size_t a = 0; a < 2; ++a) {
          q[a] = report.way[k][a] + (report.way[k + 1][a] - report.way[k][a]) * i / 100;
        }
        nearest = std::min(nearest, yard.distance(q, nullptr));
      }
    }
    return nearest;
  };
  const PlanReport bold = planned(yard, potential(0, 1), {0, 6}, {10, 4});
  const PlanReport shy = planned(yard, potential(3, 3), {0, 6}, {10, 4});
  ASSERT_TRUE(bold.found()) << bold.cause;
  ASSERT_TRUE(shy.found()) << shy.cause;
  EXPECT_GT(least(shy), least(bold));
}

}  // namespace
}  // namespace rubicon::guides
