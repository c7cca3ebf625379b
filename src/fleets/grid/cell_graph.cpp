#include "src/fleets/grid/cell_graph.hpp"

namespace rubicon::grid {

CellGraph::CellGraph(const GridMap& map)
    : map_columns_(static_cast<std::size_t>(map.columns)), ids_(map.open.size(), -1) {
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.columns; ++x) {
      if (!map.is_open({x, y})) continue;
      ids_[map.index({x, y})] = size();
      cells_.push_back({x, y});
    }
  }
  beside_.resize(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell at = cells_[i];
    for (const Cell next : std::array<Cell, 4>{
             {{at.x + 1, at.y}, {at.x, at.y + 1}, {at.x - 1, at.y}, {at.x, at.y - 1}}}) {
      if (!map.is_open(next)) continue;
      Row& row = beside_[i];
      row.ids[static_cast<std::size_t>(row.count++)] = id(next);
    }
  }
}

}  // namespace rubicon::grid
