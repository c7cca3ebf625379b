#pragma once

#include <cstddef>
#include <vector>

#include "src/motion/guides/planners.hpp"

namespace rubicon::guides {

/// A leg in the queue of A*, which may lead further.
struct QueuedLeg {
  double whole = 0;  ///< cost to its end, and what is left from there
  double cost = 0;
  std::size_t number = 0;
  int from = 0;  ///< what was reached before it
  bool at_goal = false;

  /// Whether it comes after another one: of equals the one nearer to the goal is first, then the
  /// one found first.
  bool operator<(const QueuedLeg& other) const {
    if (whole != other.whole) return whole > other.whole;
    if (cost != other.cost) return cost < other.cost;
    return number > other.number;
  }
};

/// What A* reached, the start first, into the answer: how much, and the tree where it is told.
template <typename Reached>
void tell_reached(const std::vector<Reached>& reached, Space& space, Search& search) {
  search.nodes = reached.size();
  search.out_of_nodes = !space.spent();
  for (std::size_t i = 1; space.spec().tells_tree && i < reached.size(); ++i) {
    const auto from = static_cast<std::size_t>(reached[i].from);
    search.tree.emplace_back(reached[from].point, reached[i].point);
  }
}

}  // namespace rubicon::guides
