#include "src/fleets/lanes/lane_network.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "src/fleets/lanes/grid.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/lanes/lane_fixtures.hpp"

namespace rubicon::lanes {
namespace {

// Two bays and a gate, joined by a road.
NetworkDescription yard() {
  return {{{"road", 2, 4, 1}, {"alley", 1, 3, 1}},
          {{"gate", 0, 0}, {"bay1", 30, 40}, {"bay2", 30, 80}},
          {{0, 1, 0}, {1, 0, 0}, {1, 2, 1, 100.0}}};
}

// What the one fault of a changed yard is.
std::string fault(const std::function<void(NetworkDescription&)>& change) {
  NetworkDescription description = yard();
  change(description);
  const std::vector<NetworkFault> faults = faults_of(description);
  EXPECT_EQ(faults.size(), 1U);
  try {
    LaneNetwork network(description);
    ADD_FAILURE() << "was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(faults.empty() ? "" : faults.front().message, error.what());
    return error.what();
  }
  return "";
}

TEST(LaneNetwork, KnowsItsNodesAndLanes) {
  const LaneNetwork network(yard());
  EXPECT_EQ(network.node_count(), 3);
  EXPECT_EQ(network.lane_count(), 3);
  EXPECT_EQ(network.find_node("bay2"), 2);
  EXPECT_EQ(network.find_node("bay3"), kNone);
  EXPECT_EQ(network.find_node(""), kNone);
  EXPECT_EQ(network.find_lane(1, 2), 2);
  EXPECT_EQ(network.find_lane(2, 1), kNone);
  EXPECT_EQ(network.length(0), 50);
  EXPECT_EQ(network.length(2), 100);
  EXPECT_EQ(network.time(0), 25 * kSecond);
  EXPECT_EQ(network.time(0, 1), 50 * kSecond);
  EXPECT_EQ(network.time(2, 5), 100 * kSecond);
  EXPECT_EQ(network.name_of(2), "bay1 to bay2");
  EXPECT_EQ(std::vector<LaneIndex>(network.leaving(1).begin(), network.leaving(1).end()),
            (std::vector<LaneIndex>{1, 2}));
  EXPECT_TRUE(network.leaving(2).empty());
  EXPECT_EQ(network.bounds().stretch, 1);
  EXPECT_EQ(network.bounds().speed, 2);
}

TEST(LaneNetwork, TakesNothingAndNodesWithoutLanes) {
  EXPECT_EQ(LaneNetwork({}).node_count(), 0);
  const LaneNetwork network({{}, {{"a", 0, 0}}, {}});
  EXPECT_TRUE(network.leaving(0).empty());
}

TEST(LaneNetwork, ALaneBesideAnotherHasThatOneBesideIt) {
  NetworkDescription description = yard();
  description.lanes[1].beside = 0;
  const LaneNetwork network(description);
  EXPECT_EQ(network.lane(0).beside, 1);
  EXPECT_EQ(network.lane(1).beside, 0);
  EXPECT_EQ(network.lane(2).beside, kNone);
}

TEST(LaneNetwork, SaysWhatIsWrong) {
  using D = NetworkDescription;
  EXPECT_EQ(fault([](D& d) { d.lanes[2].to = 7; }),
            "lane number 3: its end is an unknown node; there are 3 nodes");
  EXPECT_EQ(fault([](D& d) { d.lanes[2].from = -1; }),
            "lane number 3: its start is an unknown node; there are 3 nodes");
  EXPECT_EQ(fault([](D& d) { d.lanes.push_back({0, 1, 1}); }), "lane gate to bay1 is listed twice");
  EXPECT_EQ(fault([](D& d) {
              d.lanes.push_back({2, 2, 1, 4.0});
            }),
            "lane bay2 to bay2 ends where it starts");
  EXPECT_EQ(fault([](D& d) { d.lanes[2].length = 0; }),
            "lane bay1 to bay2: expected a length above 0 m, found 0");
  EXPECT_EQ(fault([](D& d) { d.lanes[2].length = -3; }),
            "lane bay1 to bay2: expected a length above 0 m, found -3");
  EXPECT_EQ(fault([](D& d) { d.lanes[2].length = std::numeric_limits<double>::quiet_NaN(); }),
            "lane bay1 to bay2: expected a length above 0 m, found nan");
  EXPECT_EQ(fault([](D& d) {
              d.nodes.push_back({"bay3", 30, 80});
              d.lanes.push_back({2, 3, 1});
            }),
            "lane bay2 to bay3: both nodes are at the same place; give the lane a length");
  EXPECT_EQ(fault([](D& d) {
              d.nodes[2].x = 1e300;
              d.lanes[2].length.reset();
            }),
            "lane bay1 to bay2: its nodes are too far apart; give the lane a length");
  EXPECT_EQ(fault([](D& d) { d.lanes[2].lane_class = 2; }),
            "lane bay1 to bay2 is of an unknown class");
  EXPECT_EQ(fault([](D& d) { d.lanes[2].beside = 2; }), "lane bay1 to bay2 is beside itself");
  EXPECT_EQ(fault([](D& d) { d.lanes[2].beside = 3; }),
            "lane bay1 to bay2 is beside an unknown lane");
  EXPECT_EQ(fault([](D& d) {
              d.lanes[0].beside = 1;
              d.lanes[2].beside = 1;
            }),
            "lane bay1 to gate is beside two lanes: lane gate to bay1 and lane bay1 to bay2");
  EXPECT_EQ(fault([](D& d) { d.nodes[2].name = "gate"; }), "node gate is there twice");
  EXPECT_EQ(fault([](D& d) { d.nodes[2].name.clear(); }), "node number 3 has no name");
  EXPECT_EQ(fault([](D& d) {
              d.nodes.push_back({"bay3", std::numeric_limits<double>::infinity(), 0});
            }),
            "node bay3: its place is not a number");
  EXPECT_EQ(fault([](D& d) { d.classes[1].speed = 0; }),
            "class alley: expected a speed above 0, found 0");
  EXPECT_EQ(fault([](D& d) { d.classes[1].width = -1; }),
            "class alley: expected a width above 0, found -1");
  EXPECT_EQ(fault([](D& d) { d.classes[1].cost = -1; }),
            "class alley: expected a cost of 0 or more, found -1");
  EXPECT_EQ(fault([](D& d) { d.classes[1].name = "road"; }), "class road is there twice");
}

TEST(LaneNetwork, TellsAllFaultsAtOnceAndNotTooMany) {
  NetworkDescription description = yard();
  description.lanes[0].length = 0;
  description.lanes[2].lane_class = 9;
  description.nodes[1].name = "gate";
  const std::vector<NetworkFault> faults = faults_of(description);
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[0].node, 1);
  EXPECT_EQ(faults[1].lane, 0);
  EXPECT_EQ(faults[2].lane, 2);
  EXPECT_EQ(faults_of(description, 2).size(), 2U);
}

TEST(LaneNetwork, TimesAreWholeNanosecondsAndNeverNothing) {
  EXPECT_EQ(nanoseconds_of(1.5), 1'500'000'000);
  EXPECT_EQ(nanoseconds_of(1e-30), 1);
  EXPECT_EQ(nanoseconds_of(2.5e-9), 3);
  EXPECT_EQ(nanoseconds_of(1e300), kEndOfTime);
  EXPECT_EQ(nanoseconds_of(std::numeric_limits<double>::quiet_NaN()), kEndOfTime);
}

TEST(LaneNetwork, AMillionNodesAreBuiltAndAnswer) {
  const int side = test::cases(1000);
  const LaneNetwork network(grid({side, side, 5}));
  EXPECT_EQ(network.node_count(), side * side);
  EXPECT_EQ(network.lane_count(), 4 * side * (side - 1));
  const NodeIndex from = node(network, "x0y0");
  const NodeIndex to = node(network, "x" + std::to_string(side - 1) + "y0");
  const std::optional<Way> way = shortest_way(network, from, to);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->time, (side - 1) * 5 * kSecond);
  const WaysFrom ways = ways_from(network, from);
  EXPECT_EQ(ways.weight.back(), 2 * (side - 1) * 5 * kSecond);
}

TEST(Grid, RefusesWhatIsNoGrid) {
  EXPECT_THROW(grid({0, 5}), std::invalid_argument);
  EXPECT_THROW(grid({100'000, 100'000}), std::invalid_argument);
  EXPECT_THROW(grid({2, 2, 0}), std::invalid_argument);
  EXPECT_EQ(grid({1, 1}).lanes.size(), 0U);
}

}  // namespace
}  // namespace rubicon::lanes
