#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "src/motion/guides/planners.hpp"
#include "src/motion/math/random.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/guides/guide_machines.hpp"

namespace rubicon::guides {
namespace {

using rubicon::test::at_least;
using rubicon::test::cases;
using Q = std::vector<double>;

/// Rectangles of the plane in which nothing may be; one of them comes or goes at each change.
class Site {
 public:
  /// At most `most` rectangles, with sides of at most `longest` (m).
  Site(Random& random, std::size_t most, double longest)
      : random_(random), most_(most), longest_(longest) {}

  void change() {
    if (boxes_.size() > most_ || (!boxes_.empty() && random_.uniform() < 0.3)) {
      const auto gone =
          static_cast<std::ptrdiff_t>(random_.uniform() * static_cast<double>(boxes_.size()));
      boxes_.erase(boxes_.begin() + gone);
      return;
    }
    const double x = random_.between(0, 9);
    const double y = random_.between(0, 9);
    boxes_.push_back(
        {x, y, x + random_.between(0.3, longest_), y + random_.between(0.3, longest_)});
  }

  bool operator()(std::span<const double> q) const {
    return std::any_of(boxes_.begin(), boxes_.end(), [&](const std::array<double, 4>& box) {
      return q[0] > box[0] && q[0] < box[2] && q[1] > box[1] && q[1] < box[3];
    });
  }

 private:
  Random& random_;
  std::size_t most_;
  double longest_;
  std::vector<std::array<double, 4>> boxes_;
};

struct Totals {
  int found = 0;
  int none = 0;
  std::size_t repaired = 0;  ///< expansions
  std::size_t searched = 0;  ///< the same of A*
};

/// Changes the site again and again and compares the repaired lattice with a new search by A*.
/// `moves`: how far (m) the robot goes on each time, at most, in x and y.
Totals compare(const robot::RobotModel& model, Neighbours neighbours, const Q& goal, int changes,
               double moves, double pitch = 1, std::size_t boxes = 12, double longest = 3) {
  const robot::Mounting mounting = test::standing(model);
  GuideSpec spec = default_guide(GuideKind::dstar_lite);
  spec.neighbours = neighbours;
  spec.step = 10 * pitch;
  GuideSpec fresh = default_guide(GuideKind::astar);
  fresh.neighbours = neighbours;
  fresh.step = spec.step;
  Random random(17);
  Site site(random, boxes, longest);
  PlanMemory memory;
  Totals totals;
  Q from = goal;
  from[0] = 0.7;
  from[1] = 1.2;
  for (int i = 0; i < changes; ++i) {
    site.change();
    for (const std::size_t axis :
         i % 3 == 0 ? std::vector<std::size_t>{0, 1} : std::vector<std::size_t>{}) {
      from[axis] = std::clamp(from[axis] + random.between(-moves, moves), 0.0, 10.0);
    }
    test::PredicateTests tests{site};
    if (site(from) || site(goal)) continue;
    Space repaired_space(model, mounting, from, spec, tests);
    const Search repaired = repair_lattice(repaired_space, repaired_space.point(from),
                                           repaired_space.point(goal), memory.lattice);
    Space fresh_space(model, mounting, from, fresh, tests);
    const Search searched =
        search_lattice(fresh_space, fresh_space.point(from), fresh_space.point(goal));
    SCOPED_TRACE(testing::Message() << "change " << i);
    EXPECT_EQ(repaired.way.empty(), searched.way.empty());
    totals.repaired += repaired.nodes;
    totals.searched += searched.nodes;
    if (repaired.way.empty() || searched.way.empty()) {
      ++totals.none;
      continue;
    }
    ++totals.found;
    EXPECT_NEAR(repaired.cost, searched.cost, 1e-9 * (1 + searched.cost));
    EXPECT_EQ(repaired.way.front(), repaired_space.point(from));
    EXPECT_EQ(repaired.way.back(), repaired_space.point(goal));
    for (std::size_t k = 0; k + 1 < repaired.way.size(); ++k) {
      EXPECT_TRUE(repaired_space.leg_is_free(repaired.way[k], repaired.way[k + 1]));
    }
  }
  return totals;
}

TEST(DStarLite, CostsWhatAStarCostsAfterEachOfAThousandChanges) {
  const Totals all = compare(test::gantry(), Neighbours::all, {8.3, 7.6}, cases(500), 0);
  const Totals straight = compare(test::gantry(), Neighbours::straight, {8.3, 7.6}, cases(500), 0);
  EXPECT_GT(all.found, at_least(200));
  if (rubicon::test::kFewerCases == 1) {
    EXPECT_GT(all.none + straight.none, 5);
    EXPECT_LT(all.repaired, all.searched);
    EXPECT_LT(straight.repaired, straight.searched);
  }
  RecordProperty("repaired", static_cast<int>(all.repaired));
  RecordProperty("searched", static_cast<int>(all.searched));
}

TEST(DStarLite, AChangeNearTheRobotIsSoonRepaired) {
  const robot::RobotModel model = test::gantry();
  const robot::Mounting mounting = test::standing(model);
  GuideSpec spec = default_guide(GuideKind::dstar_lite);
  spec.step = 2.5;  // 0.25 m
  const Q from{1, 1};
  const Q goal{9, 2};
  const auto wall = [](std::span<const double> q) { return q[0] > 4 && q[0] < 6 && q[1] < 8; };
  const auto crate = [&](std::span<const double> q) {
    return wall(q) || (q[0] > 1.4 && q[0] < 2 && q[1] > 2 && q[1] < 2.6);
  };
  PlanMemory memory;
  test::PredicateTests before{wall};
  Space first(model, mounting, from, spec, before);
  ASSERT_FALSE(repair_lattice(first, from, goal, memory.lattice).way.empty());
  test::PredicateTests after{crate};
  Space second(model, mounting, from, spec, after);
  const Search repaired = repair_lattice(second, from, goal, memory.lattice);
  GuideSpec fresh = spec;
  fresh.kind = GuideKind::astar;
  Space third(model, mounting, from, fresh, after);
  const Search searched = search_lattice(third, from, goal);
  EXPECT_NEAR(repaired.cost, searched.cost, 1e-9);
  EXPECT_GT(repaired.nodes, 0u);
  EXPECT_LT(10 * repaired.nodes, searched.nodes);
  RecordProperty("repaired", static_cast<int>(repaired.nodes));
  RecordProperty("searched", static_cast<int>(searched.nodes));
}

TEST(DStarLite, CostsTheSameWhereverTheRobotStands) {
  EXPECT_GT(compare(test::gantry(), Neighbours::all, {8.3, 7.6}, cases(200), 10).found,
            at_least(100));
  // Many small ways, whose lengths add up with rounding.
  EXPECT_GT(
      compare(test::gantry(), Neighbours::all, {8.3, 7.6}, cases(500), 0.7, 0.7, 50, 0.9).found,
      at_least(100));
}

TEST(DStarLite, CostsTheSameForAVehicle) {
  const Totals totals = compare(test::vehicle(), Neighbours::all, {8, 7, 0}, cases(60), 0);
  EXPECT_GT(totals.found, at_least(20));
  if (rubicon::test::kFewerCases == 1) {
    EXPECT_LT(totals.repaired, totals.searched);
  }
}

TEST(DynamicTree, EveryLegIsFreeHoweverOftenTheSiteChanges) {
  const robot::RobotModel model = test::gantry();
  const robot::Mounting mounting = test::standing(model);
  GuideSpec spec = default_guide(GuideKind::drrt);
  spec.step = 10;
  Random random(5);
  Site site(random, 12, 3);
  PlanMemory memory;
  const Q goal{8.3, 7.6};
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    site.change();
    const Q from{random.between(0, 10), random.between(0, 10)};
    if (site(from) || site(goal)) continue;
    test::PredicateTests tests{site};
    Space space(model, mounting, from, spec, tests);
    const std::vector<Point> way = search_tree(space, from, goal, memory.tree).way;
    for (std::size_t k = 0; k < memory.tree->points.size(); ++k) {
      ASSERT_LT(memory.tree->parents[k], static_cast<int>(k));
    }
    ASSERT_EQ(memory.tree->points.front(), goal);
    if (way.empty()) continue;
    ++found;
    EXPECT_EQ(way.front(), from);
    EXPECT_EQ(way.back(), goal);
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
      EXPECT_TRUE(tests.sweeps_free(way[k], way[k + 1])) << "change " << i;
    }
  }
  EXPECT_GT(found, 100);
}

TEST(DynamicTree, GoesOnWithWhatItHas) {
  const robot::RobotModel model = test::gantry();
  const robot::Mounting mounting = test::standing(model);
  test::PredicateTests tests(
      [](std::span<const double> q) { return q[0] > 4 && q[0] < 6 && q[1] < 8; });
  GuideSpec spec = default_guide(GuideKind::drrt);
  spec.step = 10;
  PlanMemory memory;
  const Q from{1, 1};
  const Q goal{9, 1};
  Space first(model, mounting, from, spec, tests);
  const Search whole = search_tree(first, from, goal, memory.tree);
  ASSERT_GT(whole.way.size(), 4u);
  const Point further = whole.way[1];
  Space second(model, mounting, further, spec, tests);
  ASSERT_FALSE(search_tree(second, further, goal, memory.tree).way.empty());
  EXPECT_LT(4 * second.checks(), first.checks());
}

TEST(GoalTree, TrimsANodeWithAllThatLeadsOnToIt) {
  GoalTree tree{{{0}, {1}, {2}, {3}, {4}}, {-1, 0, 1, 0, 2}};
  tree.trim(1);
  EXPECT_EQ(tree.points, (std::vector<Point>{{0}, {3}}));
  EXPECT_EQ(tree.parents, (std::vector<int>{-1, 0}));
}

}  // namespace
}  // namespace rubicon::guides
