#include "src/fleets/lanes/warehouse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "src/fleets/lanes/covering_walk.hpp"
#include "tests/unit/lanes/lane_fixtures.hpp"

namespace rubicon::lanes {
namespace {

constexpr const char* kPlanned = "A B BB1 B1 B1B3 B3 B3B5 B5";
// The ways that the paper prints for a blocked segment, and the one that is there by symmetry.
constexpr const char* kFirstPrinted = "A B C CC1 C1 C1C3 C3 C3C5 C8 B3B5 B5";
constexpr const char* kSecondPrinted = "A B BB1 B1 B1B3 B3 C8C10 C3 C3C5 C8 B3B5 B5";
constexpr const char* kThird = "A A1 A1A3 A3 A3A5 A5 B6B8 B5";

// Seconds of a walk by names; 0 where a lane is missing or among those that are blocked.
double seconds(const LaneNetwork& network, const std::string& walk,
               const std::vector<LaneIndex>& blocked = {}) {
  std::istringstream words(walk);
  std::string from;
  std::string to;
  words >> from;
  Nanoseconds time = 0;
  while (words >> to) {
    const LaneIndex i = network.find_lane(node(network, from), node(network, to));
    if (i == kNone || std::find(blocked.begin(), blocked.end(), i) != blocked.end()) return 0;
    time += network.time(i);
    from = to;
  }
  return static_cast<double>(time) / kSecond;
}

std::string best(const LaneNetwork& network, const std::string& from, const std::string& to,
                 const std::vector<LaneIndex>& closed = {}) {
  WayOptions options;
  options.closed = closed;
  return told(network, shortest_way(network, node(network, from), node(network, to), options));
}

TEST(Warehouse, SuccessorsAreAsPrinted) {
  const LaneNetwork network(warehouse());
  std::vector<NodeIndex> after;
  for (const LaneIndex i : network.leaving(node(network, "B8"))) {
    after.push_back(network.lane(i).to);
  }
  EXPECT_EQ(told(network, after), "B8B10 A3A5");
}

TEST(Warehouse, ThePlannedWayIsTheOnlyBestOneWhileTheHighwayIsQuick) {
  for (const double hop : {1.0, 15.0, 39.9}) {
    WarehouseQuery query;
    query.hop = hop;
    const LaneNetwork network(warehouse(query));
    EXPECT_EQ(best(network, "A", "B5"), kPlanned);
    // It is the only one: without any of its lanes the best way takes longer.
    const double planned = seconds(network, kPlanned);
    EXPECT_NEAR(planned, 150 + hop, 1e-9);
    const auto way = shortest_way(network, node(network, "A"), node(network, "B5"));
    for (const LaneIndex i : way->lanes) {
      WayOptions options;
      const std::vector<LaneIndex> closed = {i};
      options.closed = closed;
      const auto other = shortest_way(network, node(network, "A"), node(network, "B5"), options);
      ASSERT_TRUE(other);
      EXPECT_GT(other->time, way->time);
    }
  }
  WarehouseQuery query;
  query.hop = 40;
  EXPECT_EQ(seconds(LaneNetwork(warehouse(query)), kPlanned),
            seconds(LaneNetwork(warehouse(query)), kThird));
  query.hop = 41;
  const LaneNetwork slow(warehouse(query));
  EXPECT_EQ(shortest_way(slow, node(slow, "A"), node(slow, "B5"))->time, 190 * kSecond);
}

TEST(Warehouse, PrintedAlternativesAreWaysWithThePrintedSegmentOfThem) {
  const LaneNetwork network(warehouse());
  EXPECT_EQ(seconds(network, kFirstPrinted), 220);
  EXPECT_EQ(seconds(network, kSecondPrinted), 245);
  EXPECT_EQ(seconds(network, kThird), 190);
  // The paper's blocked segment, B1B3 to B3, is part of its second alternative.
  const std::vector<LaneIndex> printed = {lane(network, "B1B3", "B3")};
  EXPECT_EQ(seconds(network, kFirstPrinted, printed), 220);
  EXPECT_EQ(seconds(network, kSecondPrinted, printed), 0);
  EXPECT_EQ(seconds(network, kPlanned, printed), 0);
  // With the next segment blocked both are ways.
  const std::vector<LaneIndex> next = {lane(network, "B3", "B3B5")};
  EXPECT_EQ(seconds(network, kFirstPrinted, next), 220);
  EXPECT_EQ(seconds(network, kSecondPrinted, next), 245);
  EXPECT_EQ(seconds(network, kPlanned, next), 0);
  // Neither is the best: by corridor A it takes 190 s, in the first case by two ways.
  WayOptions options;
  options.closed = printed;
  const auto way = shortest_way(network, node(network, "A"), node(network, "B5"), options);
  EXPECT_EQ(way->time, 190 * kSecond);
  EXPECT_EQ(seconds(network, "A A1 A1A3 A3 B8B10 B3 B3B5 B5", printed), 190);
  EXPECT_EQ(best(network, "A", "B5", next), kThird);
  WarehouseQuery query;
  query.hop = 40;
  const LaneNetwork slow(warehouse(query));
  EXPECT_EQ(seconds(slow, kFirstPrinted), seconds(slow, kSecondPrinted));
}

TEST(Warehouse, WaysOfTheWorkedExampleAreTheBestOnes) {
  const LaneNetwork network(warehouse());
  EXPECT_EQ(best(network, "B3", "B7"), "B3 B3B5 B5 B5B7 B7");
  EXPECT_EQ(best(network, "B6", "B10"), "B6 B6B8 B8 B8B10 B10");
  EXPECT_EQ(best(network, "C6C8", "B10"), "C6C8 C8 B3B5 B8 B8B10 B10");
  EXPECT_EQ(seconds(network, "C8 B3B5"), 20);  // not the 40 of the paper's sentence about costs
}

TEST(Warehouse, LanesLieBesideThoseAcrossTheCorridor) {
  const LaneNetwork network(warehouse());
  const auto beside = [&](const char* from, const char* to) {
    const LaneIndex other = network.lane(lane(network, from, to)).beside;
    return other == kNone ? "none" : network.name_of(other);
  };
  EXPECT_EQ(beside("B3", "B3B5"), "B8 to B8B10");
  EXPECT_EQ(beside("B6", "B6B8"), "B5 to B5B7");
  EXPECT_EQ(beside("A1", "A1A3"), "A10 to A10A12");
  EXPECT_EQ(beside("B3B5", "B5"), "B6B8 to B8");
  EXPECT_EQ(beside("A", "B"), "B to A");
  EXPECT_EQ(beside("B3B5", "B8"), "none");
}

TEST(Warehouse, EveryNodeCanBeReachedFromEveryNode) {
  for (const bool far_gates : {true, false}) {
    for (const int corridors : {1, 2, 5}) {
      for (const int rows : {1, 2, 5}) {
        WarehouseQuery query;
        query.corridors = corridors;
        query.rows = rows;
        query.far_gates = far_gates;
        query.middle_node_at_first_gate = far_gates;
        const LaneNetwork network(warehouse(query));
        for (NodeIndex from = 0; from < network.node_count(); ++from) {
          for (const std::int64_t weight : ways_from(network, from).weight) {
            EXPECT_LT(weight, kNoWay);
          }
        }
        EXPECT_GE(network.bounds().stretch, 1) << "a lane is shorter than the straight line";
      }
    }
  }
}

TEST(Warehouse, TheMiddleNodeOfTheFirstGateChangesNoTime) {
  WarehouseQuery query;
  query.middle_node_at_first_gate = true;
  const LaneNetwork network(warehouse(query));
  EXPECT_EQ(seconds(network, "A AA1 A1"), 30);
  EXPECT_EQ(seconds(LaneNetwork(warehouse()), "A A1"), 30);
}

TEST(Warehouse, CanBeExploredWithoutAMap) {
  const LaneNetwork network(warehouse());
  const Travelways ways = travelways_of(network);
  const NodeIndex start = node(network, "A");
  EXPECT_EQ(covering_walk(Exploration::kTarry, ways.graph, start).size(),
            2 * ways.graph.edges.size());
  EXPECT_LT(covering_walk(Exploration::kFraenkel, ways.graph, start).size(),
            2 * ways.graph.edges.size());
}

TEST(Warehouse, RefusesWhatIsNoWarehouse) {
  const auto refused = [](auto change) {
    WarehouseQuery query;
    change(query);
    EXPECT_THROW(warehouse(query), std::invalid_argument);
  };
  refused([](WarehouseQuery& q) { q.corridors = 0; });
  refused([](WarehouseQuery& q) { q.corridors = 27; });
  refused([](WarehouseQuery& q) { q.rows = 0; });
  refused([](WarehouseQuery& q) { q.hop = 0; });
  refused([](WarehouseQuery& q) { q.along = -1; });
}

}  // namespace
}  // namespace rubicon::lanes
