#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/bodies.hpp"

namespace rubicon::collision::test {
namespace {

/// What stands where, under a name that insertions and removals do not change.
struct Standing {
  BodyPtr body;
  Pose X;
};
using Site = std::map<int, Standing>;

/// A world and the names of its obstacles.
struct Named {
  CollisionWorld world;
  std::map<ObstacleId, int> names;

  void insert(int name, const Standing& standing) {
    names[world.insert(standing.body, standing.X)] = name;
  }
  void remove(int name) {
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&](const auto& entry) { return entry.second == name; });
    world.remove(found->first);
    names.erase(found);
  }
};

double site_size(int count) {
  double size = 1;
  while (8 * size * size * size < 3.0 * count) size *= 1.1;
  return size;
}

SweptQuery random_query(Random& random, const BodyPtr& body, double size) {
  const Pose X = random.pose(size);
  const Motion motion = random.below(2)
                            ? geometry::translating(X, random.vector(0.5))
                            : turning(X, random.direction(), X.translation() + random.vector(5),
                                      random.between(-10, 10));
  SweptQuery query;
  query.items = {item(*body, motion)};
  return query;
}

/// The names of all that blocks.
std::set<int> blockers(const Named& named, const SweptQuery& query) {
  std::set<int> result;
  for (const BlockingPair& pair : named.world.explain(query))
    result.insert(named.names.at(pair.hit.obstacle.value()));
  return result;
}

Site random_site(Random& random, int count) {
  const std::vector<BodyPtr> bodies = site_bodies();
  const double size = site_size(count);
  Site site;
  for (int name = 0; name < count; ++name) {
    const BodyPtr& body = bodies[random.below(static_cast<int>(bodies.size()))];
    site[name] = {body, random.pose(size)};
  }
  return site;
}

class SiteOfSize : public testing::TestWithParam<int> {};

TEST_P(SiteOfSize, TheOrderOfInsertionDoesNotMatter) {
  Random random(301 + GetParam());
  const Site site = random_site(random, GetParam());
  const double size = site_size(GetParam());
  Named forwards;
  Named shuffled;
  for (const auto& [name, standing] : site) forwards.insert(name, standing);
  std::vector<int> order;
  for (const auto& [name, standing] : site) order.push_back(name);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(static_cast<int>(i))]);
  for (const int name : order) shuffled.insert(name, site.at(name));
  const BodyPtr load = box(Vec3(0.3, 0.2, 0.6));
  int hits = 0;
  for (int i = 0; i < rubicon::test::cases(300); ++i) {
    const SweptQuery query = random_query(random, load, size);
    const std::set<int> expected = blockers(forwards, query);
    ASSERT_EQ(blockers(shuffled, query), expected) << "query " << i;
    for (const Named* named : {&forwards, &shuffled}) {
      const SweptResult result = named->world.test(query);
      ASSERT_EQ(result.hit.has_value(), !expected.empty()) << "query " << i;
      if (!result.hit) continue;
      ++hits;
      // The first by id, whatever the order in the tree.
      const ObstacleId first = *result.hit->obstacle;
      for (const auto& [id, name] : named->names) {
        if (id < first) {
          EXPECT_EQ(expected.count(name), 0U);
        }
      }
      EXPECT_EQ(expected.count(named->names.at(first)), 1U);
    }
  }
  EXPECT_GT(hits, GetParam() > 10 ? rubicon::test::at_least(50) : 0);
}

TEST_P(SiteOfSize, ChangesLeaveNoTrace) {
  Random random(302 + GetParam());
  const std::vector<BodyPtr> bodies = site_bodies();
  const double size = site_size(GetParam());
  Site site = random_site(random, GetParam());
  Named changed;
  for (const auto& [name, standing] : site) changed.insert(name, standing);
  int next_name = GetParam();
  const BodyPtr load = box(Vec3(0.3, 0.2, 0.6));
  for (int round = 0; round < 6; ++round) {
    for (int change = 0; change < rubicon::test::cases(400); ++change) {
      const bool grow = site.empty() || (static_cast<int>(site.size()) <= GetParam() + 5 &&
                                         (site.size() < 2 || random.below(2) == 0));
      if (grow) {
        const Standing standing{bodies[random.below(static_cast<int>(bodies.size()))],
                                random.pose(size)};
        changed.insert(next_name, standing);
        site[next_name++] = standing;
      } else {
        auto victim = site.lower_bound(random.below(next_name));
        if (victim == site.end()) victim = site.begin();
        changed.remove(victim->first);
        site.erase(victim);
      }
    }
    Named fresh;
    // Names rise with the ids of the changed world, so that the first of both is the same.
    for (const auto& [name, standing] : site) fresh.insert(name, standing);
    for (int i = 0; i < 60; ++i) {
      const SweptQuery query = random_query(random, load, size);
      const auto old_list = changed.world.explain(query);
      const auto new_list = fresh.world.explain(query);
      ASSERT_EQ(old_list.size(), new_list.size());
      for (std::size_t k = 0; k < old_list.size(); ++k) {
        EXPECT_EQ(changed.names.at(*old_list[k].hit.obstacle),
                  fresh.names.at(*new_list[k].hit.obstacle));
        EXPECT_EQ(old_list[k].contact.fraction, new_list[k].contact.fraction);
        EXPECT_EQ(old_list[k].contact.point_W, new_list[k].contact.point_W);
      }
      const SweptResult first = changed.world.test(query);
      ASSERT_EQ(first.hit.has_value(), !old_list.empty());
      if (first.hit) {
        EXPECT_EQ(*first.hit->obstacle, *old_list.front().hit.obstacle);
      }
      const Clearance old_miss = changed.world.clearance(query, 2.0);
      const Clearance new_miss = fresh.world.clearance(query, 2.0);
      EXPECT_EQ(old_miss.lower_bound, new_miss.lower_bound);
      EXPECT_EQ(old_miss.upper_bound, new_miss.upper_bound);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, SiteOfSize, testing::Values(1, 2, 9, 70, 600, 5000));

TEST(ExplainProperty, NamesEachPairThatBlocksAlone) {
  Random random(303);
  const std::vector<BodyPtr> bodies = site_bodies();
  int pairs = 0;
  for (int i = 0; i < rubicon::test::cases(300); ++i) {
    const Site site = random_site(random, 30);
    Named named;
    for (const auto& [name, standing] : site) named.insert(name, standing);
    SweptQuery query;
    for (int k = 0; k < 3; ++k) {
      const BodyPtr& body = bodies[random.below(static_cast<int>(bodies.size()))];
      query.items.push_back(random_query(random, body, 1).items.front());
    }
    query.items[2].against_world = random.below(2) == 0;
    query.pairs = {{0, 1}, {2, 0}};
    query.ignore = {3, 7};
    std::vector<SweptHit> expected;
    for (int k = 0; k < 3; ++k) {
      if (!query.items[k].against_world) continue;
      for (const auto& [id, name] : named.names) {
        if (id == 3 || id == 7) continue;
        const MovingBody& moving = query.items[k].moving;
        if (blocked(*moving.body, moving.motion, site.at(name).body, site.at(name).X, 1e-3))
          expected.push_back({k, id, std::nullopt});
      }
    }
    for (const auto& [first, second] : query.pairs) {
      const MovingBody& a = query.items[first].moving;
      const MovingBody& b = query.items[second].moving;
      if (pair_blocked(*a.body, a.motion, *b.body, b.motion, 1e-3))
        expected.push_back({first, std::nullopt, second});
    }
    const std::vector<BlockingPair> found = named.world.explain(query);
    ASSERT_EQ(found.size(), expected.size()) << "case " << i;
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].hit.item, expected[k].item);
      EXPECT_EQ(found[k].hit.obstacle, expected[k].obstacle);
      EXPECT_EQ(found[k].hit.other_item, expected[k].other_item);
      const Contact alone = named.world.contact(query, found[k].hit);
      EXPECT_EQ(alone.fraction, found[k].contact.fraction);
      EXPECT_EQ(alone.point_W, found[k].contact.point_W);
    }
    pairs += static_cast<int>(found.size());
  }
  EXPECT_GT(pairs, rubicon::test::at_least(300));
}

}  // namespace
}  // namespace rubicon::collision::test
