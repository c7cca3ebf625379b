#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "src/motion/ompl_bridge/ompl_planners.hpp"
#include "src/motion/ompl_bridge/ompl_plugin.hpp"

namespace rubicon::ompl_bridge {

extern "C" const OmplPlugin* rubicon_ompl(int version);

namespace {

using Blocked = std::function<bool(std::span<const double>)>;

/// Coordinates from 0 to 10, or angles that turn freely; legs are sampled very finely.
class Square : public Question {
 public:
  explicit Square(Blocked blocked, std::size_t most_checks = 20000, std::size_t size = 2)
      : blocked_(std::move(blocked)), most_checks_(most_checks), size_(size) {}

  std::size_t size() const override { return size_; }
  double lower(std::size_t i) const override { return cyclic(i) ? -180 : 0; }
  double upper(std::size_t i) const override { return cyclic(i) ? 180 : 10; }
  double weight(std::size_t i) const override { return cyclic(i) ? 1 : 10; }
  bool cyclic(std::size_t i) const override { return any_cyclic && i == 0; }
  bool keeps() const override { return kept; }
  bool symmetric() const override { return true; }
  void fit(Point& point) const override {
    // x + y = 10.
    const double off = (point[0] + point[1] - 10) / 2;
    point[0] = std::clamp(point[0] - off, 0.0, 10.0);
    point[1] = 10 - point[0];
  }
  bool stands(std::span<const double> point) override {
    ++checks;
    for (std::size_t i = 0; i < size_; ++i) {
      if (!(point[i] >= lower(i) && point[i] <= upper(i))) ++outside;
    }
    if (kept && std::fabs(point[0] + point[1] - 10) > 1e-6) return false;
    return !blocked_(point);
  }
  bool leg_is_free(std::span<const double> a, std::span<const double> b) override {
    ++checks;
    constexpr int kParts = 300;
    Point point(size_);
    for (int k = 0; k <= kParts; ++k) {
      for (std::size_t i = 0; i < size_; ++i) {
        double off = b[i] - a[i];
        if (cyclic(i)) off = std::remainder(off, 360);
        point[i] = a[i] + off * k / kParts;
        if (cyclic(i)) point[i] = std::remainder(point[i], 360);
      }
      if (kept && std::fabs(point[0] + point[1] - 10) > 1e-6) return false;
      if (blocked_(point)) return false;
    }
    return true;
  }
  bool spent() const override { return checks >= most_checks_; }

  bool any_cyclic = false;
  bool kept = false;
  std::size_t checks = 0;
  std::size_t outside = 0;

 private:
  Blocked blocked_;
  std::size_t most_checks_;
  std::size_t size_;
};

const OmplPlugin& plugin() { return *rubicon_ompl(kOmplPluginVersion); }

Asked asked_of(const std::string& planner, double seed = 1) {
  Asked asked;
  asked.planner = planner;
  asked.seed = seed;
  asked.nodes = 20000;
  asked.start = {1, 1};
  asked.goal = {9, 1};
  return asked;
}

std::vector<std::string> taken() {
  std::vector<std::string> names;
  for (const OmplPlanner& each : ompl_planners()) {
    if (each.taken()) names.emplace_back(each.name);
  }
  return names;
}

/// A wall across the square with a gap at the top.
bool in_wall(std::span<const double> q) { return q[0] > 4 && q[0] < 6 && q[1] < 7; }
/// Of an angle: half the turn is free, with a wall at 180 degrees.
bool beyond_wall(std::span<const double> q) {
  return std::fabs(q[0]) < 90 || (std::fabs(q[0]) > 170 && q[1] < 7);
}
bool in_closed_wall(std::span<const double> q) { return q[0] > 4 && q[0] < 6; }

/// SST takes long for its first way.
std::size_t checks_for(const std::string& name) { return name == "SST" ? 20000 : 3000; }

TEST(OmplPlanners, TheTableSaysWhatTheLibraryHas) {
  for (const OmplPlanner& each : ompl_planners()) {
    const std::vector<std::string> names = plugin().parameters(each.name);
    for (const std::string& name : parameters_of(each)) {
      EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << each.name << ' ' << name;
    }
    EXPECT_EQ(each.taken(), !names.empty() || std::string(each.name) == "LazyPRMstar") << each.name;
  }
}

TEST(OmplPlanners, AllFindAFreeWayAndInAnyOrderTheSameSeedGivesTheSame) {
  std::map<std::string, std::vector<Point>> ways;
  for (const std::string& name : taken()) {
    Square square(in_wall, checks_for(name));
    const Answer answer = plugin().plan(square, asked_of(name));
    ASSERT_FALSE(answer.way.empty()) << name << ": " << answer.cause;
    EXPECT_EQ(answer.way.front(), (Point{1, 1})) << name;
    EXPECT_EQ(answer.way.back(), (Point{9, 1})) << name;
    EXPECT_GT(answer.nodes, 1u) << name;
    EXPECT_EQ(square.outside, 0u) << name;
    for (std::size_t k = 0; k + 1 < answer.way.size(); ++k) {
      EXPECT_TRUE(square.leg_is_free(answer.way[k], answer.way[k + 1])) << name;
    }
    ways[name] = answer.way;
  }
  std::vector<std::string> names = taken();
  std::reverse(names.begin(), names.end());
  for (const std::string& name : names) {
    Square square(in_wall, checks_for(name));
    EXPECT_EQ(plugin().plan(square, asked_of(name)).way, ways[name]) << name;
  }
  for (const std::string name : {"RRT", "RRTConnect", "EST"}) {
    Square square(in_wall);
    EXPECT_NE(plugin().plan(square, asked_of(name, 2)).way, ways[name]) << name;
  }
}

TEST(OmplPlanners, LimitsEndASearchWithoutAWay) {
  for (const std::string& name : taken()) {
    for (const double nodes : {50.0, 2000.0}) {
      Square square(in_closed_wall, 500);
      Asked asked = asked_of(name);
      asked.nodes = nodes;
      const Answer answer = plugin().plan(square, asked);
      EXPECT_TRUE(answer.way.empty()) << name;
      EXPECT_LE(square.checks, 500u) << name;
      EXPECT_TRUE(nodes > 100 || answer.nodes <= 120) << name << " " << answer.nodes;
    }
  }
}

TEST(OmplPlanners, AnglesTurnTheShortWayRound) {
  // Those of cells, which know no angle that turns round, take longer.
  for (const std::string name : {"RRTConnect", "AITstar", "InformedRRTstar", "SORRTstar", "FMT"}) {
    Square square(beyond_wall, checks_for(name));
    square.any_cyclic = true;
    Asked asked = asked_of(name);
    asked.start = {-150, 5};
    asked.goal = {150, 5};
    const Answer answer = plugin().plan(square, asked);
    EXPECT_FALSE(answer.way.empty()) << name << ": " << answer.cause;
    for (std::size_t k = 0; k + 1 < answer.way.size(); ++k) {
      EXPECT_TRUE(square.leg_is_free(answer.way[k], answer.way[k + 1])) << name;
    }
  }
}

TEST(OmplPlanners, WhatIsKeptHolds) {
  for (const std::string name : {"RRTConnect", "BITstar", "KPIECE1", "InformedRRTstar"}) {
    Square square([](std::span<const double>) { return false; });
    square.kept = true;
    Asked asked = asked_of(name);
    asked.start = {1, 9};
    asked.goal = {9, 1};
    const Answer answer = plugin().plan(square, asked);
    EXPECT_FALSE(answer.way.empty()) << name << ": " << answer.cause;
    for (const Point& point : answer.way) EXPECT_NEAR(point[0] + point[1], 10, 1e-9) << name;
  }
}

TEST(OmplPlanners, ParametersAreSet) {
  Square square(in_wall);
  Asked asked = asked_of("RRT");
  asked.range = 2;
  asked.tells_tree = true;
  Answer answer = plugin().plan(square, asked);
  ASSERT_FALSE(answer.tree.empty());
  for (const auto& [from, to] : answer.tree) {
    EXPECT_LE(10 * std::hypot(to[0] - from[0], to[1] - from[1]), 2 + 1e-9);
  }
  asked.settings = {{"range", 4}};
  Square again(in_wall);
  answer = plugin().plan(again, asked);
  double longest = 0;
  for (const auto& [from, to] : answer.tree) {
    longest = std::max(longest, 10 * std::hypot(to[0] - from[0], to[1] - from[1]));
  }
  EXPECT_NEAR(longest, 4, 1e-9);
  asked.planner = "FMT";
  asked.settings = {{"num_samples", 60}};
  EXPECT_LE(plugin().plan(again, asked).nodes, 62u);
}

}  // namespace
}  // namespace rubicon::ompl_bridge
