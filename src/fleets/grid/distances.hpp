#pragma once

#include <cstdint>
#include <vector>

#include "src/fleets/grid/cell_graph.hpp"

namespace rubicon::grid {

/// Steps from each cell to the goal of each agent, as if nobody else were there. Found by a
/// breadth-first search from each goal, which goes on only when a cell is asked for that it has not
/// seen. Cells from which there is no way are never asked for. There may be more goals than agents:
/// each agent looks at one of them, at first at that of its own number.
class Distances {
 public:
  Distances(const CellGraph& graph, std::vector<CellId> goals);

  int of(int agent, CellId cell) { return to_goal(seen_[static_cast<std::size_t>(agent)], cell); }
  int to_goal(int goal, CellId cell) {
    const std::uint16_t known =
        table_[static_cast<std::size_t>(goal) * cells_ + static_cast<std::size_t>(cell)];
    return known != kUnknown ? known : search(goal, cell);
  }
  void set_goal(int goal, CellId cell);
  /// From now on `of(agent, ...)` is the distance to that goal.
  void look_at(int agent, int goal) { seen_[static_cast<std::size_t>(agent)] = goal; }

 private:
  static constexpr std::uint16_t kUnknown = 0xFFFF;
  int search(int goal, CellId cell);

  const CellGraph& graph_;
  std::size_t cells_;
  std::vector<std::uint16_t> table_;
  std::vector<std::vector<CellId>> border_;  ///< by goal: the cells that were seen last
  std::vector<int> seen_;                    ///< by agent: its goal
  std::vector<CellId> next_;
};

}  // namespace rubicon::grid
