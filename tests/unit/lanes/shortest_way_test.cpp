#include "src/fleets/lanes/shortest_way.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "src/fleets/lanes/grid.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/lanes/lane_fixtures.hpp"

namespace rubicon::lanes {
namespace {

// Few places, so that many lanes tie; some lanes are short cuts, some detours.
NetworkDescription random_network(TestRandom& random, int nodes, bool short_cuts) {
  NetworkDescription result;
  result.classes = {{"fast", 3, 4, 2}, {"slow", 1, 2.5, 1}, {"free", 0.5, 1.5, 0}};
  for (int i = 0; i < nodes; ++i) {
    result.nodes.push_back(
        {"n" + std::to_string(i), 1.0 * random.whole(0, 4), 1.0 * random.whole(0, 4)});
  }
  for (int a = 0; a < nodes; ++a) {
    for (int b = 0; b < nodes; ++b) {
      if (a == b || random.whole(0, 9) > 2) continue;
      Lane lane{a, b, random.whole(0, 2)};
      const Node& from = result.nodes[static_cast<std::size_t>(a)];
      const Node& to = result.nodes[static_cast<std::size_t>(b)];
      const bool apart = from.x != to.x || from.y != to.y;
      if (!apart || random.whole(0, 3) == 0) {
        lane.length = short_cuts ? 0.25 * random.whole(1, 8) : 6.0 + random.whole(0, 4);
      }
      result.lanes.push_back(lane);
    }
  }
  return result;
}

std::int64_t weight_of_lane(const LaneNetwork& network, LaneIndex i, const WayOptions& options) {
  if (options.criterion == Criterion::kTime) {
    return nanoseconds_of(network.length(i) /
                          std::min(network.class_of(i).speed, options.vehicle_speed));
  }
  const double cost = options.criterion == Criterion::kCost ? network.class_of(i).cost : 1;
  return nanoseconds_of(network.length(i) * cost);
}

// All nodes by Bellman and Ford, which knows no order and no estimate; then the stated rule for
// ties, seen from the goal backwards.
std::optional<std::vector<LaneIndex>> plain_way(const LaneNetwork& network, NodeIndex from,
                                                NodeIndex to, const WayOptions& options) {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max() / 4;
  std::vector<std::int64_t> weight(static_cast<std::size_t>(network.node_count()), kFar);
  weight[static_cast<std::size_t>(from)] = 0;
  const auto usable = [&](LaneIndex i) {
    return network.class_of(i).width >= options.vehicle_width &&
           std::find(options.closed.begin(), options.closed.end(), i) == options.closed.end();
  };
  for (int round = 0; round < network.node_count(); ++round) {
    for (LaneIndex i = 0; i < network.lane_count(); ++i) {
      if (!usable(i)) continue;
      std::int64_t& there = weight[static_cast<std::size_t>(network.lane(i).to)];
      there = std::min(there, weight[static_cast<std::size_t>(network.lane(i).from)] +
                                  weight_of_lane(network, i, options));
    }
  }
  if (weight[static_cast<std::size_t>(to)] >= kFar) return std::nullopt;
  std::vector<LaneIndex> way;
  while (to != from) {
    LaneIndex i = 0;
    while (!usable(i) || network.lane(i).to != to ||
           weight[static_cast<std::size_t>(network.lane(i).from)] +
                   weight_of_lane(network, i, options) !=
               weight[static_cast<std::size_t>(to)]) {
      ++i;
    }
    way.insert(way.begin(), i);
    to = network.lane(i).from;
  }
  return way;
}

TEST(ShortestWay, IsThatOfAPlainSearchInRandomNetworks) {
  TestRandom random(1);
  int found = 0;
  int none = 0;
  for (int i = 0; i < test::cases(3000); ++i) {
    SCOPED_TRACE(i);
    const LaneNetwork network(random_network(random, random.whole(2, 14), i % 2 == 0));
    std::vector<LaneIndex> closed;
    for (LaneIndex lane = 0; lane < network.lane_count(); ++lane) {
      if (random.whole(0, 7) == 0) closed.push_back(lane);
    }
    WayOptions options;
    options.criterion = static_cast<Criterion>(random.whole(0, 2));
    if (random.whole(0, 1) == 0) options.vehicle_speed = 0.5 * random.whole(1, 5);
    options.vehicle_width = random.whole(0, 3);
    options.closed = closed;
    const NodeIndex from = random.whole(0, network.node_count() - 1);
    const NodeIndex to = random.whole(0, network.node_count() - 1);
    const std::optional<Way> way = shortest_way(network, from, to, options);
    const std::optional<std::vector<LaneIndex>> plain = plain_way(network, from, to, options);
    ASSERT_EQ(way.has_value(), plain.has_value());
    const WaysFrom ways = ways_from(network, from, options);
    const std::optional<Way> same = way_to(network, ways, to, options);
    ASSERT_EQ(same.has_value(), plain.has_value());
    if (!way) {
      ++none;
      continue;
    }
    ++found;
    EXPECT_EQ(way->lanes, *plain);
    EXPECT_EQ(same->lanes, *plain);
    EXPECT_EQ(way->nodes.front(), from);
    EXPECT_EQ(way->nodes.back(), to);
    EXPECT_EQ(way->nodes.size(), way->lanes.size() + 1);
  }
  EXPECT_GT(found, test::cases(3000) / 4);
  EXPECT_GT(none, test::cases(3000) / 10);
}

TEST(ShortestWay, LooksAtFewerNodesThanASearchForAll) {
  const LaneNetwork network(grid({60, 60, 5}));
  SearchCounts counts;
  const NodeIndex from = node(network, "x30y30");
  const NodeIndex to = node(network, "x50y30");
  ASSERT_TRUE(shortest_way(network, from, to, {}, counts));
  EXPECT_EQ(counts.expanded, 21);
}

TEST(ShortestWay, MinimisesWhatItIsAskedTo) {
  // By a: fast, long and dear; by b: slow, short and cheap; by c in between, for nothing.
  const LaneNetwork network(
      {{{"fast", 10, 4, 5}, {"slow", 1, 4, 1}, {"free", 1, 4, 0}},
       {{"s", 0, 0}, {"a", 50, 50}, {"b", 50, 0}, {"c", 50, -20}, {"t", 100, 0}},
       {{0, 1, 0}, {1, 4, 0}, {0, 2, 1}, {2, 4, 1}, {0, 3, 2}, {3, 4, 2}}});
  const auto by = [&](Criterion criterion, double speed) {
    WayOptions options;
    options.criterion = criterion;
    options.vehicle_speed = speed;
    return told(network, shortest_way(network, 0, 4, options));
  };
  EXPECT_EQ(by(Criterion::kTime, 20), "s a t");
  EXPECT_EQ(by(Criterion::kTime, 1), "s b t");  // a slow vehicle gains nothing
  EXPECT_EQ(by(Criterion::kDistance, 20), "s b t");
  EXPECT_EQ(by(Criterion::kCost, 20), "s c t");
  EXPECT_EQ(name_of(Criterion::kDistance), "distance");
}

TEST(ShortestWay, OfWaysEquallyGoodTakesTheFirstLaneSeenFromTheGoal) {
  // A square: both ways round take the same time.
  const NetworkDescription square{{{"lane", 1, 4, 1}},
                                  {{"s", 0, 0}, {"a", 0, 1}, {"b", 1, 0}, {"t", 1, 1}},
                                  {{0, 1}, {0, 2}, {2, 3}, {1, 3}}};
  EXPECT_EQ(told(LaneNetwork(square), shortest_way(LaneNetwork(square), 0, 3)), "s b t");
  NetworkDescription other = square;
  std::swap(other.lanes[2], other.lanes[3]);
  EXPECT_EQ(told(LaneNetwork(other), shortest_way(LaneNetwork(other), 0, 3)), "s a t");
}

TEST(ShortestWay, KeepsOutOfClosedAndNarrowLanes) {
  const LaneNetwork network({{{"wide", 1, 4, 1}, {"narrow", 1, 2, 1}},
                             {{"s", 0, 0}, {"a", 0, 5}, {"t", 5, 0}},
                             {{0, 2, 1}, {0, 1, 0}, {1, 2, 0}}});
  EXPECT_EQ(told(network, shortest_way(network, 0, 2)), "s t");
  WayOptions options;
  options.vehicle_width = 3;
  EXPECT_EQ(told(network, shortest_way(network, 0, 2, options)), "s a t");
  const std::vector<LaneIndex> closed = {2};
  options.closed = closed;
  EXPECT_EQ(told(network, shortest_way(network, 0, 2, options)), "no way");
  EXPECT_EQ(told(network, shortest_way(network, 2, 0)), "no way");
  EXPECT_EQ(told(network, shortest_way(network, 2, 2)), "t");
}

TEST(ShortestWay, AWayWithoutEndIsNoWay) {
  const LaneNetwork network({{{"lane", 1e-6, 4, 1}},
                             {{"a", 0, 0}, {"b", 8e3, 0}, {"c", 16e3, 0}},
                             {{0, 1, 0}, {1, 2, 0}}});
  EXPECT_TRUE(shortest_way(network, 0, 1));
  EXPECT_FALSE(shortest_way(network, 0, 2));
  EXPECT_FALSE(way_to(network, ways_from(network, 0), 2));
}

TEST(ShortestWay, RefusesWhatMakesNoSense) {
  const LaneNetwork network({{{"lane"}}, {{"a", 0, 0}, {"b", 1, 0}}, {{0, 1}, {1, 0}}});
  EXPECT_THROW(shortest_way(network, 0, 2), std::invalid_argument);
  EXPECT_THROW(shortest_way(network, -1, 0), std::invalid_argument);
  EXPECT_THROW(ways_from(network, 5), std::invalid_argument);
  EXPECT_THROW(way_to(network, ways_from(network, 0), 5), std::invalid_argument);
  WayOptions options;
  options.vehicle_speed = 0;
  EXPECT_THROW(shortest_way(network, 0, 1, options), std::invalid_argument);
  options = {};
  options.vehicle_width = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(shortest_way(network, 0, 1, options), std::invalid_argument);
  options = {};
  const std::vector<LaneIndex> descending = {1, 0};
  options.closed = descending;
  EXPECT_THROW(shortest_way(network, 0, 1, options), std::invalid_argument);
  const std::vector<LaneIndex> unknown = {2};
  options.closed = unknown;
  EXPECT_THROW(shortest_way(network, 0, 1, options), std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::lanes
