#include "src/fleets/lanes/covering_walk.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "src/fleets/lanes/grid.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/lanes/lane_fixtures.hpp"

namespace rubicon::lanes {
namespace {

Multigraph random_graph(TestRandom& random) {
  Multigraph graph;
  graph.nodes = random.whole(1, 9);
  const int edges = random.whole(0, 14);
  for (int i = 0; i < edges; ++i) {
    graph.edges.push_back({random.whole(0, graph.nodes - 1), random.whole(0, graph.nodes - 1)});
  }
  return graph;
}

// The edges that can be reached from a node, by growing the set until nothing is new.
std::set<std::int32_t> reachable_edges(const Multigraph& graph, std::int32_t start) {
  std::set<std::int32_t> nodes = {start};
  std::set<std::int32_t> edges;
  for (std::size_t before = 0; before != nodes.size() + edges.size();) {
    before = nodes.size() + edges.size();
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      if (!nodes.contains(graph.edges[i].a) && !nodes.contains(graph.edges[i].b)) continue;
      nodes.insert({graph.edges[i].a, graph.edges[i].b});
      edges.insert(static_cast<std::int32_t>(i));
    }
  }
  return edges;
}

// How often the walk goes along each edge from a to b and from b to a; a loop counts as a to b.
// Fails where a step does not begin at the end of the one before, or is not on its edge.
std::vector<std::array<int, 2>> counted(const Multigraph& graph, std::int32_t start,
                                        const std::vector<WalkStep>& walk) {
  std::vector<std::array<int, 2>> count(graph.edges.size(), {0, 0});
  std::int32_t now = start;
  for (const WalkStep& step : walk) {
    EXPECT_EQ(step.from, now);
    const Multigraph::Edge& edge = graph.edges[static_cast<std::size_t>(step.edge)];
    const bool there = step.from == edge.a && step.to == edge.b;
    EXPECT_TRUE(there || (step.from == edge.b && step.to == edge.a));
    ++count[static_cast<std::size_t>(step.edge)][there ? 0 : 1];
    now = step.to;
  }
  EXPECT_EQ(now, start) << "the walk is not closed";
  return count;
}

TEST(CoveringWalk, TarryGoesAlongEachEdgeOnceInEachDirection) {
  TestRandom random(2);
  int loops = 0;
  int apart = 0;
  for (int i = 0; i < test::cases(10'000); ++i) {
    SCOPED_TRACE(i);
    const Multigraph graph = random_graph(random);
    const std::int32_t start = random.whole(0, graph.nodes - 1);
    const std::set<std::int32_t> reachable = reachable_edges(graph, start);
    const auto walk = covering_walk(Exploration::kTarry, graph, start);
    EXPECT_EQ(walk.size(), 2 * reachable.size());
    const auto count = counted(graph, start, walk);
    for (std::size_t e = 0; e < count.size(); ++e) {
      const bool is_loop = graph.edges[e].a == graph.edges[e].b;
      const int there = reachable.contains(static_cast<std::int32_t>(e)) ? 1 : 0;
      EXPECT_EQ(count[e][0], is_loop ? 2 * there : there);
      EXPECT_EQ(count[e][1], is_loop ? 0 : there);
      loops += is_loop ? 1 : 0;
      apart += 1 - there;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(loops, test::at_least(1000));
  EXPECT_GT(apart, test::at_least(1000));
}

TEST(CoveringWalk, FraenkelCoversAndGoesNowhereThrice) {
  TestRandom random(3);
  std::size_t steps = 0;
  std::size_t of_tarry = 0;
  for (int i = 0; i < test::cases(10'000); ++i) {
    SCOPED_TRACE(i);
    const Multigraph graph = random_graph(random);
    const std::int32_t start = random.whole(0, graph.nodes - 1);
    const std::set<std::int32_t> reachable = reachable_edges(graph, start);
    const auto walk = covering_walk(Exploration::kFraenkel, graph, start);
    const auto count = counted(graph, start, walk);
    for (std::size_t e = 0; e < count.size(); ++e) {
      const int times = count[e][0] + count[e][1];
      EXPECT_EQ(times > 0, reachable.contains(static_cast<std::int32_t>(e)));
      EXPECT_LE(times, 2);
    }
    if (HasFailure()) return;
    steps += walk.size();
    of_tarry += 2 * reachable.size();
  }
  RecordProperty("fraenkel_per_mille_of_tarry", static_cast<int>(1000 * steps / of_tarry));
  EXPECT_LT(steps * 10, of_tarry * 9);
}

TEST(CoveringWalk, KnownWalks) {
  const auto nodes = [](Exploration exploration, const Multigraph& graph) {
    std::string text = "0";
    for (const WalkStep& step : covering_walk(exploration, graph, 0)) {
      text += " " + std::to_string(step.to);
    }
    return text;
  };
  const Multigraph triangle{3, {{0, 1}, {1, 2}, {2, 0}}};
  EXPECT_EQ(nodes(Exploration::kTarry, triangle), "0 1 2 0 2 1 0");
  EXPECT_EQ(nodes(Exploration::kFraenkel, triangle), "0 1 2 0");
  const Multigraph loop{1, {{0, 0}}};
  EXPECT_EQ(nodes(Exploration::kTarry, loop), "0 0 0");
  EXPECT_EQ(nodes(Exploration::kFraenkel, loop), "0 0");
  const Multigraph dead_end{2, {{0, 1}}};
  EXPECT_EQ(nodes(Exploration::kTarry, dead_end), "0 1 0");
  EXPECT_EQ(nodes(Exploration::kFraenkel, dead_end), "0 1 0");
  EXPECT_EQ(nodes(Exploration::kTarry, {1, {}}), "0");
}

TEST(CoveringWalk, RefusesUnknownNodes) {
  EXPECT_THROW(covering_walk(Exploration::kTarry, {1, {}}, 1), std::invalid_argument);
  EXPECT_THROW(covering_walk(Exploration::kTarry, {1, {{0, 1}}}, 0), std::invalid_argument);
  EXPECT_THROW(covering_walk(Exploration::kTarry, {0, {}}, 0), std::invalid_argument);
}

TEST(CoveringWalk, ExploresTheTravelwaysOfANetwork) {
  const LaneNetwork network(grid({3, 3, 5}));
  const Travelways ways = travelways_of(network);
  EXPECT_EQ(ways.graph.edges.size(), 12U);  // 24 lanes, two by two
  EXPECT_EQ(covering_walk(Exploration::kTarry, ways.graph, 4).size(), 24U);
  const LaneNetwork one_way(
      {{{"lane"}}, {{"a", 0, 0}, {"b", 1, 0}, {"c", 2, 0}}, {{1, 0}, {1, 2}}});
  EXPECT_EQ(travelways_of(one_way).lane, (std::vector<LaneIndex>{0, 1}));
}

}  // namespace
}  // namespace rubicon::lanes
