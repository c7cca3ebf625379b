#pragma once

#include <cstdint>
#include <vector>

#include "src/fleets/grid/cell_graph.hpp"

namespace rubicon::grid {

/// Steps from each cell to the goal of each agent, as if nobody else were there. Found by a
/// breadth-first search from each goal, which goes on only when a cell is asked for that it has not
/// seen. Cells from which there is no way are never asked for.
class Distances {
 public:
  Distances(const CellGraph& graph, std::vector<CellId> goals);

  int of(int agent, CellId cell) {
    const std::uint16_t known =
        table_[static_cast<std::size_t>(agent) * cells_ + static_cast<std::size_t>(cell)];
    return known != kUnknown ? known : search(agent, cell);
  }

 private:
  static constexpr std::uint16_t kUnknown = 0xFFFF;
  int search(int agent, CellId cell);

  const CellGraph& graph_;
  std::size_t cells_;
  std::vector<std::uint16_t> table_;
  std::vector<std::vector<CellId>> border_;  ///< by agent: the cells that were seen last
  std::vector<CellId> next_;
};

}  // namespace rubicon::grid
