#include <gtest/gtest.h>

#include <algorithm>

#include "src/motion/guides/planners.hpp"
#include "src/motion/math/random.hpp"
#include "tests/unit/guides/guide_machines.hpp"

namespace rubicon::guides {
namespace {

using Q = std::vector<double>;

/// A wall with a door at a height.
struct Wall {
  double door = 8;
  bool operator()(std::span<const double> q) const {
    return q[0] > 4 && q[0] < 6 && !(q[1] > door && q[1] < door + 1.6);
  }
};

class PrmTest : public ::testing::Test {
 protected:
  Search search(MotionTests& tests, const Q& from, const Q& to, RoadmapMemory& memory,
                std::size_t* checks = nullptr) {
    Space space(model_, mounting_, from, spec_, tests);
    Search found = search_roadmap(space, from, to, memory);
    if (checks) *checks = space.checks();
    return found;
  }

  robot::RobotModel model_ = test::gantry();
  robot::Mounting mounting_ = test::standing(model_);
  GuideSpec spec_ = default_guide(GuideKind::prm);
};

TEST_F(PrmTest, TheRoadmapIsThatOfSeedAndRobotAlone) {
  test::PredicateTests tests{Wall{}};
  const Q here{1, 1};
  const Q there{9, 9};
  const Roadmap one = make_roadmap(Space(model_, mounting_, here, spec_, tests));
  const Roadmap same = make_roadmap(Space(model_, mounting_, there, spec_, tests));
  EXPECT_EQ(one.points, same.points);
  EXPECT_EQ(one.next_to, same.next_to);
  ASSERT_EQ(one.points.size(), 500u);
  for (int i = 0; i < 500; ++i) {
    const std::vector<int>& next = one.next_to[static_cast<std::size_t>(i)];
    EXPECT_GE(next.size(), 10u);
    for (const int other : next) {
      const std::vector<int>& back = one.next_to[static_cast<std::size_t>(other)];
      EXPECT_TRUE(std::binary_search(back.begin(), back.end(), i));
    }
  }
}

TEST_F(PrmTest, TheMoreNodesTheMoreOftenItFindsAWay) {
  const auto solved = [&](double nodes) {
    int count = 0;
    for (double seed = 1; seed <= 40; ++seed) {
      spec_.nodes = nodes;
      spec_.seed = seed;
      test::PredicateTests tests{Wall{}};
      RoadmapMemory memory;
      if (!search(tests, {1, 1}, {9, 1}, memory).way.empty()) ++count;
    }
    return count;
  };
  const int few = solved(20);
  const int some = solved(80);
  const int many = solved(400);
  EXPECT_LT(few, some);
  EXPECT_LT(some, many);
  EXPECT_EQ(many, 40);
}

TEST_F(PrmTest, ReuseCostsATenthOfTestingTheRoadmapAndStaysRightWhenTheSiteChanges) {
  test::PredicateTests before{Wall{8}};
  test::PredicateTests after{Wall{2}};
  RoadmapMemory memory;
  std::size_t first = 0;
  std::size_t again = 0;
  std::size_t changed = 0;
  ASSERT_FALSE(search(before, {1, 1}, {9, 1}, memory, &first).way.empty());
  const auto roadmap = memory.roadmap;
  ASSERT_FALSE(search(before, {1, 2}, {9, 2}, memory, &again).way.empty());
  const std::vector<Point> way = search(after, {1, 1}, {9, 1}, memory, &changed).way;
  EXPECT_EQ(memory.roadmap, roadmap);
  ASSERT_FALSE(way.empty());
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    EXPECT_TRUE(after.sweeps_free(way[i], way[i + 1]));
  }
  std::size_t whole = roadmap->points.size();
  for (const std::vector<int>& next : roadmap->next_to) whole += next.size() / 2;
  EXPECT_LT(again, first);
  EXPECT_LE(10 * again, whole);
  EXPECT_LE(10 * changed, whole);
  RecordProperty("whole", static_cast<int>(whole));
  RecordProperty("first", static_cast<int>(first));
  RecordProperty("again", static_cast<int>(again));
  RecordProperty("changed", static_cast<int>(changed));
}

TEST_F(PrmTest, EveryLegIsFreeHoweverOftenTheSiteChanges) {
  Random random(3);
  RoadmapMemory memory;
  int found = 0;
  for (int n = 0; n < 60; ++n) {
    const double door = random.between(0, 8.4);
    test::PredicateTests tests{Wall{door}};
    const Q from{random.between(0, 4), random.between(0, 10)};
    const Q to{random.between(6, 10), random.between(0, 10)};
    const std::vector<Point> way = search(tests, from, to, memory).way;
    if (way.empty()) continue;
    ++found;
    EXPECT_EQ(way.front(), from);
    EXPECT_EQ(way.back(), to);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      EXPECT_TRUE(tests.sweeps_free(way[i], way[i + 1]));
    }
  }
  EXPECT_EQ(found, 60);
}

}  // namespace
}  // namespace rubicon::guides
