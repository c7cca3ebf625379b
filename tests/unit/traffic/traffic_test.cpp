#include "src/fleets/traffic/traffic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "src/fleets/lanes/grid.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/lanes/lane_fixtures.hpp"

namespace rubicon::traffic {
namespace {

using lanes::kNone;
using lanes::kSecond;
using lanes::TestRandom;
using Outcome = PlanResult::Outcome;

std::shared_ptr<const LaneNetwork> network_of(lanes::NetworkDescription description) {
  return std::make_shared<const LaneNetwork>(std::move(description));
}

/// Nodes 10 m apart in a row, joined both ways; lanes at 1 m/s.
lanes::NetworkDescription row(int nodes) {
  lanes::GridQuery query;
  query.columns = nodes;
  query.rows = 1;
  query.spacing = 10;
  return lanes::grid(query);
}

/// Drives vehicles as a site does, one event after the other, each lane late by chance.
class Drive {
 public:
  Drive(Traffic traffic, std::vector<std::vector<NodeIndex>> jobs, unsigned seed, int most_late)
      : traffic_(std::move(traffic)), jobs_(std::move(jobs)), random_(seed), late_(most_late) {
    arrival_.assign(jobs_.size(), -1);
  }

  /// Until nobody can go on. Each node is held by one vehicle at a time.
  void run() {
    for (bool went = true; went;) {
      went = false;
      for (int v = 0; v < traffic_.vehicles(); ++v) went |= start(v);
      int next = -1;
      for (int v = 0; v < traffic_.vehicles(); ++v) {
        const auto i = static_cast<std::size_t>(v);
        if (arrival_[i] < 0) continue;
        if (next < 0 || arrival_[i] < arrival_[static_cast<std::size_t>(next)]) next = v;
      }
      if (next >= 0) {
        now_ = arrival_[static_cast<std::size_t>(next)];
        arrival_[static_cast<std::size_t>(next)] = -1;
        traffic_.arrived(next, now_);
        went = true;
      }
      if (!went) went = untangle();
      check_holds();
      ASSERT_LT(++events_, 100000);
    }
  }

  bool all_done() const {
    return std::all_of(jobs_.begin(), jobs_.end(), [](const auto& jobs) { return jobs.empty(); });
  }

 private:
  /// When all stand: lets the first that waits get by. Who has nothing more to do may be moved.
  bool untangle() {
    std::vector<bool> movable;
    for (int v = 0; v < traffic_.vehicles(); ++v) {
      movable.push_back(traffic_.waits(v) || jobs_[static_cast<std::size_t>(v)].empty());
    }
    for (int v = 0; v < traffic_.vehicles(); ++v) {
      if (traffic_.waits(v) && traffic_.untangle(v, movable, jobs_, now_)) return true;
    }
    return false;
  }

  bool start(int v) {
    auto& jobs = jobs_[static_cast<std::size_t>(v)];
    auto& arrival = arrival_[static_cast<std::size_t>(v)];
    bool went = false;
    while (arrival < 0 && traffic_.next_of(v) == kNone && !jobs.empty()) {
      if (traffic_.node_of(v) == jobs.front()) {
        jobs.erase(jobs.begin());
        went = true;
        continue;
      }
      const PlanResult result = traffic_.plan(v, jobs.front(), now_);
      if (result.outcome == Outcome::waits || result.outcome == Outcome::no_way) return went;
    }
    if (arrival >= 0 || traffic_.next_of(v) == kNone) return went;
    if (traffic_.enter_next(v, now_)) return went;
    const std::vector<TimedNode> way = traffic_.way_of(v, now_);
    arrival = way[1].arrive + random_.whole(0, late_) * kSecond;
    return true;
  }

  void check_holds() {
    std::vector<int> holder(static_cast<std::size_t>(traffic_.network().node_count()), -1);
    const auto hold = [&](NodeIndex node, int v) {
      int& held = holder[static_cast<std::size_t>(node)];
      EXPECT_EQ(held, -1) << "at node " << traffic_.network().node(node).name;
      held = v;
    };
    for (int v = 0; v < traffic_.vehicles(); ++v) {
      hold(traffic_.node_of(v), v);
      if (traffic_.drives(v)) hold(traffic_.next_of(v), v);
    }
  }

  Traffic traffic_;
  std::vector<std::vector<NodeIndex>> jobs_;
  std::vector<Nanoseconds> arrival_;
  TestRandom random_;
  int late_;
  Nanoseconds now_ = 0;
  int events_ = 0;
};

TEST(Traffic, DrivesTheShortestWayWhenNobodyIsThere) {
  Traffic traffic(network_of(row(4)), {{1, 1, 0}});
  ASSERT_EQ(traffic.plan(0, 3, 0).outcome, Outcome::planned);
  const std::vector<TimedNode> way = traffic.way_of(0, 0);
  ASSERT_EQ(way.size(), 4u);
  EXPECT_EQ(way[3].arrive, 30 * kSecond);
  EXPECT_FALSE(traffic.enter_next(0, 0));
  traffic.arrived(0, 12 * kSecond);
  EXPECT_EQ(traffic.way_of(0, 12 * kSecond).back().arrive, 32 * kSecond);
}

TEST(Traffic, FollowsAtADistanceOfANode) {
  Traffic traffic(network_of(row(5)), {{1, 1, 1}, {1, 1, 0}});
  ASSERT_EQ(traffic.plan(0, 4, 0).outcome, Outcome::planned);
  ASSERT_EQ(traffic.plan(1, 3, 0).outcome, Outcome::planned);
  // The first leaves node 1 when it arrives at node 2.
  const std::vector<TimedNode> way = traffic.way_of(1, 0);
  EXPECT_EQ(way[1].enter, 10 * kSecond);
  const auto wait = traffic.enter_next(1, 0);
  ASSERT_TRUE(wait);
  EXPECT_EQ(wait->vehicle, 0);
  EXPECT_EQ(wait->node, 1);
}

TEST(Traffic, NamesWhoStandsInTheWayForGood) {
  Traffic traffic(network_of(row(4)), {{1, 1, 0}, {1, 1, 2}});
  const PlanResult result = traffic.plan(0, 3, 0);
  EXPECT_EQ(result.outcome, Outcome::waits);
  EXPECT_EQ(result.wait.vehicle, 1);
  EXPECT_EQ(result.wait.node, 2);
}

TEST(Traffic, GivesWayIntoASiding) {
  // Two in a corridor want to pass each other; a siding leaves its second node.
  lanes::NetworkDescription description = row(4);
  description.nodes.push_back({"siding", 10, 10, 0, true});
  description.lanes.push_back({1, 4, 0, std::nullopt, kNone});
  description.lanes.push_back({4, 1, 0, std::nullopt, kNone});
  Drive drive(Traffic(network_of(description), {{1, 1, 0}, {1, 1, 3}}), {{3}, {0}}, 1, 5);
  drive.run();
  EXPECT_TRUE(drive.all_done());
}

/// Nodes 0 to 5; lanes from node to node, one way each.
lanes::NetworkDescription one_way(const std::vector<std::pair<int, int>>& lanes) {
  lanes::NetworkDescription description;
  description.classes.push_back({"road", 2, 4, 1});
  for (int i = 0; i < 6; ++i) description.nodes.push_back({"n" + std::to_string(i), 10.0 * i});
  for (const auto& [a, b] : lanes) description.lanes.push_back({a, b, 0, 10.0, kNone});
  return description;
}

/// Where the vehicle that stands at node 1 goes when the one at node 0 asks it to let it by to
/// node 2.
NodeIndex makes_way_to(const std::vector<std::pair<int, int>>& lanes,
                       const std::vector<NodeIndex>& ahead) {
  Traffic traffic(network_of(one_way(lanes)), {{1, 1, 0}, {1, 1, 1}});
  EXPECT_EQ(traffic.plan(0, 2, 0).outcome, Outcome::waits);
  if (!traffic.untangle(0, {false, true}, {{}, ahead}, 0)) return kNone;
  EXPECT_EQ(traffic.end_of(0), 2);
  return traffic.end_of(1);
}

TEST(Traffic, MakesWayWhereLanesLeadBack) {
  // Beside node 1 are node 3, from which no lane leads, and node 4, from which one leads back.
  using Lanes = std::vector<std::pair<int, int>>;
  const Lanes road = {{0, 1}, {1, 0}, {1, 2}, {2, 1}};
  const auto with = [&](Lanes lanes) {
    lanes.insert(lanes.begin(), road.begin(), road.end());
    return lanes;
  };
  for (const std::vector<NodeIndex>& ahead : {std::vector<NodeIndex>{}, {0}, {3, 0}, {3}}) {
    EXPECT_EQ(makes_way_to(with({{1, 3}, {1, 4}, {4, 1}}), ahead), 4);
    EXPECT_EQ(makes_way_to(with({{1, 4}, {4, 1}, {1, 3}}), ahead), 4);
  }
  // Also when that takes a move more: the road goes on by node 4, and beside that is node 5.
  const Lanes longer = {{0, 1}, {1, 0}, {1, 3}, {1, 4}, {4, 1}, {4, 2}, {2, 4}, {4, 5}, {5, 4}};
  EXPECT_EQ(makes_way_to(longer, {}), 5);
  // Where no lane leads back, one that leads on to its tasks.
  EXPECT_EQ(makes_way_to({{0, 1}, {1, 2}, {1, 3}, {1, 4}, {4, 2}}, {2}), 4);
  EXPECT_EQ(makes_way_to({{0, 1}, {1, 2}, {1, 4}, {1, 3}, {3, 2}}, {2}), 3);
  // And into a dead end, if there is nothing else.
  EXPECT_EQ(makes_way_to({{0, 1}, {1, 0}, {1, 2}, {2, 1}, {1, 3}}, {0}), 3);
}

TEST(Traffic, NamesWhoCannotGoNotWhoCould) {
  // Vehicle 1 at node 1 could go to node 4 and lets nobody by to node 3, where vehicle 2 is for
  // good.
  const auto network = network_of(one_way({{0, 1}, {1, 0}, {1, 3}, {1, 4}, {4, 1}}));
  Traffic traffic(network, {{1, 1, 0}, {1, 1, 1}, {1, 1, 3}});
  EXPECT_EQ(traffic.plan(0, 3, 0).outcome, Outcome::waits);
  const std::vector<bool> movable = {false, true, true};
  EXPECT_FALSE(traffic.untangle(0, movable, {}, 0));
  const auto wait = traffic.who_bars(0, movable);
  ASSERT_TRUE(wait);
  EXPECT_EQ(wait->vehicle, 2);
  EXPECT_EQ(wait->node, 3);
}

TEST(Traffic, WaitsForEachOtherWithoutASiding) {
  Drive drive(Traffic(network_of(row(4)), {{1, 1, 0}, {1, 1, 3}}), {{3}, {0}}, 1, 5);
  drive.run();
  EXPECT_FALSE(drive.all_done());
}

TEST(Traffic, KeepsOutOfLanesThatAreTooNarrow) {
  lanes::NetworkDescription description = row(3);
  description.classes[0].width = 2;
  Traffic traffic(network_of(description), {{1, 2.5, 0}});
  EXPECT_EQ(traffic.plan(0, 2, 0).outcome, Outcome::no_way);
}

TEST(Traffic, RefusesWhatCannotBe) {
  const auto network = network_of(row(3));
  EXPECT_THROW(Traffic(network, {{1, 1, 0}, {1, 1, 0}}), std::invalid_argument);
  EXPECT_THROW(Traffic(network, {{1, 1, 3}}), std::invalid_argument);
  EXPECT_THROW(Traffic(network, {{0, 1, 0}}), std::invalid_argument);
}

/// A loop of road with a bay at each of its nodes: who has arrived is in nobody's way.
lanes::NetworkDescription yard(int bays, bool one_way) {
  lanes::NetworkDescription description;
  description.classes.push_back({"road", 2, 4, 1});
  const auto add = [&](int a, int b) { description.lanes.push_back({a, b, 0, 10.0, kNone}); };
  for (int i = 0; i < bays; ++i) description.nodes.push_back({"r" + std::to_string(i), 10.0 * i});
  for (int i = 0; i < bays; ++i)
    description.nodes.push_back({"b" + std::to_string(i), 10.0 * i, 9});
  for (int i = 0; i < bays; ++i) {
    add(i, (i + 1) % bays);
    if (!one_way) add((i + 1) % bays, i);
    add(i, bays + i);
    add(bays + i, i);
  }
  return description;
}

TEST(Traffic, BringsAllToTheirBaysWhateverIsLate) {
  const int runs = test::cases(400);
  for (int run = 0; run < runs; ++run) {
    TestRandom random(static_cast<std::uint64_t>(run));
    const int bays = 6 + run % 10;
    const int vehicles = 1 + run % (bays - 2);
    const auto network = network_of(yard(bays, run % 2 == 0));
    std::vector<Vehicle> fleet;
    std::vector<std::vector<NodeIndex>> jobs;
    for (int v = 0; v < vehicles; ++v) {
      fleet.push_back({1.0 + v % 3, 1, bays + v});
      std::vector<NodeIndex> own;
      // Last to its own bay, which nobody else keeps for good.
      for (int j = 0; j < 5; ++j) own.push_back(random.whole(bays + vehicles, 2 * bays - 1));
      own.push_back(bays + v);
      jobs.push_back(own);
    }
    Drive drive(Traffic(network, fleet), jobs, static_cast<unsigned>(run), 20);
    drive.run();
    ASSERT_TRUE(drive.all_done()) << "run " << run;
  }
}

std::vector<NodeIndex> shuffled(int count, TestRandom& random) {
  std::vector<NodeIndex> all;
  for (int i = 0; i < count; ++i) {
    all.insert(all.begin() + random.whole(0, i), i);
  }
  return all;
}

TEST(Traffic, MeetsNobodyOnAnyGrid) {
  const int runs = test::cases(1000);
  for (int run = 0; run < runs; ++run) {
    TestRandom random(static_cast<std::uint64_t>(run));
    lanes::GridQuery query;
    query.columns = 4;
    query.rows = 4;
    const auto network = network_of(lanes::grid(query));
    const std::vector<NodeIndex> nodes = shuffled(16, random);
    const std::vector<NodeIndex> goals = shuffled(16, random);
    std::vector<Vehicle> fleet;
    std::vector<std::vector<NodeIndex>> jobs;
    for (int v = 0; v < 2 + run % 5; ++v) {
      fleet.push_back({1, 1, nodes[static_cast<std::size_t>(v)]});
      jobs.push_back({goals[static_cast<std::size_t>(v)]});
    }
    Drive drive(Traffic(network, fleet), jobs, static_cast<unsigned>(run), 20);
    drive.run();
    // Who has arrived may be moved again.
    ASSERT_TRUE(drive.all_done()) << "run " << run;
  }
}

TEST(Traffic, GivesTheSameAnswersAgain) {
  const auto network = network_of(yard(8, false));
  std::vector<Vehicle> fleet = {{1, 1, 8}, {1, 1, 9}, {1, 1, 10}};
  Traffic first(network, fleet);
  Traffic second(network, fleet);
  for (int v = 0; v < 3; ++v) {
    first.plan(v, 15 - v, 0);
    second.plan(v, 15 - v, 0);
  }
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace rubicon::traffic
