#include "src/simulation/schedule/components.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "src/simulation/schedule/index.hpp"

namespace rubicon::schedule {
namespace {

using Reach = std::vector<std::vector<bool>>;

/// Whether there is a way of at least one edge between two nodes (Warshall's algorithm).
Reach reach_of(const Graph& graph) {
  const std::size_t count = graph.size();
  Reach reach(count, std::vector<bool>(count, false));
  for (std::size_t from = 0; from < count; ++from) {
    for (const int to : graph[from]) reach[from][at(to)] = true;
  }
  for (std::size_t by = 0; by < count; ++by) {
    for (std::size_t from = 0; from < count; ++from) {
      for (std::size_t to = 0; to < count; ++to) {
        if (reach[from][by] && reach[by][to]) reach[from][to] = true;
      }
    }
  }
  return reach;
}

TEST(Components, AreThoseThatReachEachOther) {
  std::mt19937 engine(7);
  int rings = 0;
  for (int i = 0; i < 300; ++i) {
    Graph graph(1 + engine() % 14);
    for (std::size_t edges = engine() % (2 * graph.size() + 1); edges > 0; --edges) {
      graph[engine() % graph.size()].push_back(static_cast<int>(engine() % graph.size()));
    }
    const Reach reach = reach_of(graph);
    const std::vector<int> components = strong_components(graph);
    for (std::size_t a = 0; a < graph.size(); ++a) {
      for (std::size_t b = 0; b < graph.size(); ++b) {
        const bool together = a == b || (reach[a][b] && reach[b][a]);
        ASSERT_EQ(components[a] == components[b], together);
        if (reach[a][b]) {
          ASSERT_GE(components[a], components[b]);
        }
      }
      const std::vector<int> ring = ring_through(graph, components, static_cast<int>(a));
      ASSERT_EQ(!ring.empty(), reach[a][a]);
      for (std::size_t place = 0; place < ring.size(); ++place) {
        const std::vector<int>& edges = graph[at(ring[place])];
        const int next = ring[(place + 1) % ring.size()];
        ASSERT_NE(std::find(edges.begin(), edges.end(), next), edges.end());
      }
      if (!ring.empty()) {
        ASSERT_EQ(ring.front(), static_cast<int>(a));
        ++rings;
      }
    }
  }
  EXPECT_GT(rings, 500);
}

TEST(Components, NameTheShortestRing) {
  const Graph graph = {{1}, {2}, {3, 0}, {0}};
  EXPECT_THAT(ring_through(graph, strong_components(graph), 0), testing::ElementsAre(0, 1, 2));
}

}  // namespace
}  // namespace rubicon::schedule
