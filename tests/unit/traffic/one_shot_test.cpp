#include "src/fleets/traffic/one_shot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "bench/exact_discs.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/traffic/roadmaps.hpp"

namespace rubicon::traffic {
namespace {

using lanes::kSecond;

constexpr double kDisc = 2.4;       // m, diameter
constexpr double kTouching = 1e-6;  // m

void expect_apart(const LaneNetwork& network, const std::vector<std::vector<TimedNode>>& ways) {
  std::vector<std::vector<TimedPlace>> tracks;
  for (const auto& way : ways) tracks.push_back(track_of(network, way));
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      ASSERT_GE(least_distance(tracks[i], tracks[k]), kDisc - kTouching) << i << " and " << k;
    }
  }
}

/// Two roads that cross without a node, 10 m from all their ends.
LaneNetwork crossing() {
  lanes::NetworkDescription description;
  description.classes.push_back({"road", 1, 4, 1});
  description.nodes = {{"w", -10, 0}, {"e", 10, 0}, {"s", 0, -10}, {"n", 0, 10}};
  description.lanes = {{0, 1}, {1, 0}, {2, 3}, {3, 2}};
  return LaneNetwork(std::move(description));
}

TEST(OneShot, LanesThatCrossAreNearToEachOther) {
  const LaneNetwork network = crossing();
  const Nearness near = nearness_of(network, kDisc);
  EXPECT_EQ(near.lanes_by_lane[0], (std::vector<LaneIndex>{2, 3}));
  EXPECT_TRUE(near.nodes_by_lane[0].empty());
  EXPECT_TRUE(near.nodes_by_node[0].empty());
  // Discs of 11 m on one road reach the ends of the other, discs of 15 m its ends from their own.
  EXPECT_EQ(nearness_of(network, 11).nodes_by_lane[0], (std::vector<NodeIndex>{2, 3}));
  EXPECT_EQ(nearness_of(network, 15).nodes_by_node[0], (std::vector<NodeIndex>{2, 3}));
}

TEST(OneShot, OneWaitsWhereLanesCross) {
  const LaneNetwork network = crossing();
  const Nearness near = nearness_of(network, kDisc);
  const std::vector<Trip> trips = {{0, 1, 1}, {2, 3, 1}};
  const OneShot found = plan_all(network, near, trips, {1000, 1});
  ASSERT_TRUE(found.solved);
  // The second sets out when the first is through.
  EXPECT_EQ(found.least, 40 * kSecond);
  EXPECT_EQ(found.cost, 60 * kSecond);
  expect_apart(network, found.ways);
  const std::vector<Precedence> order = order_of(near, found.ways);
  ASSERT_EQ(order.size(), 1u);
  EXPECT_EQ(order[0].arrives, 1);
  EXPECT_EQ(order[0].departs, 1);
}

TEST(OneShot, SaysThatThereIsNoWay) {
  lanes::NetworkDescription description;
  description.classes.push_back({"road", 1, 4, 1});
  description.nodes = {{"a", 0, 0}, {"b", 10, 0}, {"c", 20, 0}};
  description.lanes = {{0, 1}, {1, 0}};
  const LaneNetwork network(std::move(description));
  const Nearness near = nearness_of(network, kDisc);
  EXPECT_FALSE(plan_all(network, near, {{0, 2, 1}}).solved);
  // Two that want to pass each other: the budget ends it.
  EXPECT_FALSE(plan_all(network, near, {{0, 1, 1}, {1, 0, 1}}, {1000, 1}).solved);
  EXPECT_THROW(plan_all(network, near, {{0, 1, 1}, {0, 2, 1}}), std::invalid_argument);
  EXPECT_THROW(plan_all(network, near, {{0, 3, 1}}), std::invalid_argument);
  EXPECT_THROW(plan_all(network, near, {{0, 1, 0}}), std::invalid_argument);
  EXPECT_EQ(plan_all(network, near, {{0, 0, 1}}).cost, 0);
}

TEST(OneShot, DiscsNeverTouchWhateverIsLate) {
  const int runs = test::cases(30);
  int solved = 0;
  for (int run = 0; run < runs; ++run) {
    SCOPED_TRACE(run);
    RoadmapQuery query;
    query.nodes = 60;
    query.edges = run % 2 == 0 ? 110 : 240;
    query.side = 80;
    query.seed = static_cast<std::uint64_t>(run);
    const LaneNetwork network = roadmap(query);
    const Nearness near = nearness_of(network, kDisc);
    const std::vector<Trip> trips = random_trips(network, 4 + run % 9, query.seed);
    const OneShot found = plan_all(network, near, trips, {20'000, query.seed});
    // Trees of lanes have ends where somebody may want to be past whom others have to go.
    if (!found.solved) continue;
    ++solved;
    EXPECT_LE(found.least, found.cost);
    EXPECT_LE(found.cost, found.first_cost);
    expect_apart(network, found.ways);
    const std::vector<Precedence> order = order_of(near, found.ways);
    for (std::uint64_t late = 0; late < 4; ++late) {
      const auto driven = driven_late(network, trips, order, found.ways, late == 0 ? 0 : 20, late);
      for (std::size_t i = 0; i < trips.size(); ++i) {
        ASSERT_EQ(driven[i].back().node, trips[i].to);
        // In time nobody is later than planned.
        if (late == 0) {
          EXPECT_LE(driven[i].back().arrive, found.ways[i].back().arrive);
        }
      }
      expect_apart(network, driven);
    }
  }
  EXPECT_GE(solved, runs - runs / 10);
}

TEST(OneShot, CostsLittleMoreThanTheLeast) {
  // Of two that cross at a right angle the second passes behind the first: it sets out as much
  // later as the diagonal of a square of their diameter is long.
  const LaneNetwork cross = crossing();
  const auto two = bench::exact_discs(cross, kDisc, {{0, 1, 1}, {2, 3, 1}}, 100);
  ASSERT_TRUE(two);
  EXPECT_NEAR(*two, 40 + kDisc * std::sqrt(2.0), 1e-4);
  int compared = 0;
  double sum = 0;
  const int runs = test::cases(30);
  for (int run = 0; run < runs; ++run) {
    SCOPED_TRACE(run);
    RoadmapQuery query;
    query.nodes = 40;
    query.edges = 120;
    query.side = 70;
    query.seed = static_cast<std::uint64_t>(run);
    const LaneNetwork network = roadmap(query);
    const std::vector<Trip> trips = random_trips(network, 4, query.seed);
    const OneShot found =
        plan_all(network, nearness_of(network, kDisc), trips, {10'000, query.seed});
    const auto exact = bench::exact_discs(network, kDisc, trips, 300);
    if (!found.solved || !exact) continue;
    ++compared;
    const double cost = static_cast<double>(found.cost) * 1e-9;
    EXPECT_GE(cost, *exact - 1e-3);
    EXPECT_GE(*exact, static_cast<double>(found.least) * 1e-9 - 1e-3);
    sum += cost / *exact;
  }
  EXPECT_GE(compared, runs / 2);
  // A crowded yard whose lanes are kept free whole.
  EXPECT_LE(sum / compared, 1.1);
}

TEST(OneShot, FollowsWithinALaneThatIsDivided) {
  lanes::NetworkDescription description;
  description.classes.push_back({"road", 1, 4, 1});
  description.nodes = {{"a", 0, 0}, {"b", 10, 0}, {"c", 70, 0}, {"d", 80, 0}};
  description.lanes = {{0, 1}, {1, 2}, {2, 3}};
  const LaneNetwork whole(std::move(description));
  const LaneNetwork network = divided(whole, 5);
  EXPECT_EQ(network.node_count(), 4 + 1 + 11 + 1);
  const std::vector<Trip> trips = {{1, 3, 1}, {0, 2, 1}};
  // Alone 70 s each. The second enters the node of the first when that has reached its next: after
  // 60 s, or after the first 5 m.
  EXPECT_EQ(plan_all(whole, nearness_of(whole, kDisc), trips, {1000, 1}).cost, 200 * kSecond);
  EXPECT_EQ(plan_all(network, nearness_of(network, kDisc), trips, {1000, 1}).cost, 140 * kSecond);
  EXPECT_THROW(divided(whole, 0), std::invalid_argument);
}

TEST(OneShot, TheSameAgain) {
  const LaneNetwork network = roadmap({});
  const Nearness near = nearness_of(network, kDisc);
  const std::vector<Trip> trips = random_trips(network, 20, 7);
  const OneShot a = plan_all(network, near, trips, {20'000, 3});
  const OneShot b = plan_all(network, near, trips, {20'000, 3});
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.expansions, b.expansions);
}

}  // namespace
}  // namespace rubicon::traffic
