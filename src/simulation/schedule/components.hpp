#pragma once

#include <vector>

namespace rubicon::schedule {

/// A directed graph: to each node, the nodes its edges lead to.
using Graph = std::vector<std::vector<int>>;

/// To each node the number of its strongly connected component: two nodes have the same number if
/// each can be reached from the other. An edge never leads to a component with a higher number.
/// Linear in nodes and edges, without recursion. Source: R. Tarjan, "Depth-First Search and Linear
/// Graph Algorithms", SIAM J. Comput. 1 (1972).
std::vector<int> strong_components(const Graph& graph);

/// The shortest ring of edges through `node` that stays in its component: node, ..., and the edge
/// from the last leads back to `node`. Empty if there is none.
std::vector<int> ring_through(const Graph& graph, const std::vector<int>& components, int node);

}  // namespace rubicon::schedule
