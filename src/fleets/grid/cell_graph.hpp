#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "src/fleets/grid/grid_map.hpp"

namespace rubicon::grid {

/// An open cell, by its number from the top left.
using CellId = std::int32_t;

/// An index, as containers take it.
inline std::size_t at(std::ptrdiff_t index) { return static_cast<std::size_t>(index); }

/// The open cells of a map and, to each, the open cells beside it.
class CellGraph {
 public:
  explicit CellGraph(const GridMap& map);

  /// Range of the cells beside a cell.
  struct Beside {
    const CellId* first;
    const CellId* last;
    const CellId* begin() const { return first; }
    const CellId* end() const { return last; }
    int size() const { return static_cast<int>(last - first); }
  };

  int size() const { return static_cast<int>(cells_.size()); }
  Beside beside(CellId id) const {
    const auto& row = beside_[static_cast<std::size_t>(id)];
    return {row.ids.data(), row.ids.data() + row.count};
  }
  Cell cell(CellId id) const { return cells_[static_cast<std::size_t>(id)]; }
  CellId id(Cell cell) const {
    return ids_[map_columns_ * static_cast<std::size_t>(cell.y) + static_cast<std::size_t>(cell.x)];
  }

 private:
  struct Row {
    std::array<CellId, 4> ids = {};
    int count = 0;
  };
  std::size_t map_columns_;
  std::vector<CellId> ids_;  ///< -1: a wall
  std::vector<Cell> cells_;
  std::vector<Row> beside_;
};

}  // namespace rubicon::grid
