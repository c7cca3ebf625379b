#include "src/motion/collision/tree/wide_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "random_scene.hpp"

namespace rubicon::collision::test {
namespace {

Bounds bounds_at(const Vec3& lower, const Vec3& size) {
  Bounds bounds;
  bounds.add(lower);
  bounds.add(lower + size);
  return bounds;
}

Bounds random_bounds(Random& random, double site, double size) {
  const Vec3 lower = random.vector(site);
  return bounds_at(lower, random.vector(size).cwiseAbs());
}

std::set<int> collected(const WideTree& tree, const Bounds& bounds) {
  ItemList found;
  tree.collect(bounds, found);
  std::set<int> result(found.begin(), found.end());
  EXPECT_EQ(result.size(), static_cast<std::size_t>(found.size())) << "an item was found twice";
  return result;
}

/// Everything that meets the bounds is found, and nothing that is 1e-4 m (a few float roundings of
/// the sizes used here) away from them.
void expect_agreement(const WideTree& tree, const std::map<int, Bounds>& items,
                      const Bounds& bounds) {
  const std::set<int> found = collected(tree, bounds);
  Bounds grown = bounds;
  grown.grow(Vec3::Constant(1e-4));
  for (const auto& [item, own] : items) {
    if (!own.disjoint(bounds)) {
      EXPECT_EQ(found.count(item), 1U) << item;
    } else if (own.disjoint(grown)) {
      EXPECT_EQ(found.count(item), 0U) << item;
    }
  }
}

TEST(WideTree, AnEmptyOneFindsNothing) {
  const WideTree tree;
  EXPECT_TRUE(collected(tree, bounds_at(Vec3::Zero(), Vec3::Ones())).empty());
  EXPECT_EQ(tree.distance(bounds_at(Vec3::Zero(), Vec3::Ones()), 5.0), 5.0);
}

TEST(WideTree, FindsWhatAScanFindsWhileItChanges) {
  Random random(7);
  WideTree tree;
  std::map<int, Bounds> items;
  std::vector<int> free_items;
  int next = 0;
  for (int round = 0; round < 6000; ++round) {
    // Grows to some hundred items, then falls, then grows again.
    const bool grows = (round / 1500) % 2 == 0;
    if (items.empty() || random.unit() < (grows ? 0.7 : 0.3)) {
      int item = next;
      if (free_items.empty()) {
        ++next;
      } else {
        item = free_items.back();
        free_items.pop_back();
      }
      items[item] = random_bounds(random, 20, 3);
      tree.insert(item, items[item]);
    } else {
      auto victim = items.begin();
      std::advance(victim, random.below(static_cast<int>(items.size())));
      tree.remove(victim->first);
      free_items.push_back(victim->first);
      items.erase(victim);
    }
    // Another box for one of them: smaller, somewhat larger, or elsewhere.
    if (!items.empty() && random.unit() < 0.5) {
      auto changed = items.begin();
      std::advance(changed, random.below(static_cast<int>(items.size())));
      const int way = random.below(3);
      Bounds& bounds = changed->second;
      if (way < 2) bounds.grow((way == 0 ? -0.3 : 0.05) * bounds.half());
      if (way == 2) bounds = random_bounds(random, 20, 3);
      tree.replace(changed->first, bounds);
    }
    ASSERT_EQ(tree.size(), static_cast<int>(items.size()));
    if (round % 10 == 0) expect_agreement(tree, items, random_bounds(random, 20, 5));
  }
}

TEST(WideTree, BuiltAtOnceFindsWhatAScanFinds) {
  Random random(8);
  for (const int count : {1, 7, 8, 9, 64, 65, 1000}) {
    std::vector<Bounds> list;
    std::map<int, Bounds> items;
    for (int i = 0; i < count; ++i) {
      list.push_back(random_bounds(random, 20, 2));
      items[i] = list.back();
    }
    const WideTree tree(list);
    for (int i = 0; i < 50; ++i) expect_agreement(tree, items, random_bounds(random, 20, 5));
  }
}

TEST(WideTree, TenThousandEqualBoxesDoNotMakeItDeep) {
  WideTree tree;
  const Bounds same = bounds_at(Vec3::Zero(), Vec3::Ones());
  for (int i = 0; i < 10000; ++i) tree.insert(i, same);
  EXPECT_EQ(collected(tree, same).size(), 10000U);
  for (int i = 0; i < 10000; i += 2) tree.remove(i);
  EXPECT_EQ(collected(tree, same).size(), 5000U);
}

TEST(WideTree, BoxesInARowAreAllFound) {
  WideTree tree;
  for (int i = 0; i < 5000; ++i) tree.insert(i, bounds_at(Vec3(i, 0, 0), Vec3(0.5, 1, 1)));
  for (int i = 0; i < 5000; i += 37) {
    EXPECT_EQ(collected(tree, bounds_at(Vec3(i + 0.1, 0, 0), Vec3(0.1, 1, 1))), std::set<int>{i});
  }
}

TEST(WideTree, FarFromTheOriginItIsAsSharp) {
  WideTree tree;
  const Vec3 far(1e5, -2e5, 3e4);
  for (int i = 0; i < 100; ++i) tree.insert(i, bounds_at(far + Vec3(i, 0, 0), Vec3(0.99, 1, 1)));
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(collected(tree, bounds_at(far + Vec3(i + 0.4, 0.4, 0.4), Vec3::Constant(0.1))),
              std::set<int>{i});
  }
}

TEST(WideTree, BoxesWithoutBoundAreMetByEverything) {
  WideTree tree;
  Bounds everything;
  everything.lower = Vec3::Constant(-std::numeric_limits<double>::infinity());
  everything.upper = -everything.lower;
  tree.insert(0, bounds_at(Vec3::Zero(), Vec3::Ones()));
  tree.insert(1, everything);
  for (int i = 2; i < 300; ++i) tree.insert(i, bounds_at(Vec3(i, 0, 0), Vec3::Ones()));
  EXPECT_EQ(collected(tree, bounds_at(Vec3(1e9, 0, 0), Vec3::Ones())), std::set<int>{1});
  EXPECT_EQ(collected(tree, everything).size(), 300U);
  Bounds unknown;
  unknown.lower = unknown.upper = Vec3::Constant(std::nan(""));
  EXPECT_EQ(collected(tree, unknown).size(), 300U) << "not a number must not pass for far away";
}

TEST(WideTree, ItsDistanceIsThatOfTheNearestBox) {
  Random random(9);
  WideTree tree;
  std::vector<Bounds> items;
  for (int i = 0; i < 500; ++i) {
    items.push_back(random_bounds(random, 30, 2));
    tree.insert(i, items.back());
  }
  for (int i = 0; i < 500; ++i) {
    const Bounds asked = random_bounds(random, 40, 1);
    double nearest = 3;
    for (const Bounds& item : items) {
      const Vec3 gap = (item.lower - asked.upper).cwiseMax(asked.lower - item.upper).cwiseMax(0.0);
      nearest = std::min(nearest, gap.norm());
    }
    const double found = tree.distance(asked, 3);
    EXPECT_LE(found, nearest);
    EXPECT_GE(found, nearest - 1e-4);
  }
}

}  // namespace
}  // namespace rubicon::collision::test
