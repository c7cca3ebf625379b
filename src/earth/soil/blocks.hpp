#pragma once

#include <vector>

#include "src/earth/soil/terrain.hpp"

namespace rubicon::soil {

/// A box of soil over cells, in {E}: columns and rows from first to end, heights in mm.
struct Block {
  int first_column = 0, end_column = 0;
  int first_row = 0, end_row = 0;
  Millimetres bottom = 0, top = 0;

  CubicMillimetres volume(Millimetres cell) const {
    return static_cast<CubicMillimetres>(end_column - first_column) * (end_row - first_row) * cell *
           cell * (top - bottom);
  }
};

/// What lies above the one surface and under the other, of the same cells: cells with the same
/// bottom and top together, in rectangles. No two blocks share more than a face.
std::vector<Block> blocks_between(const Terrain& under, const Terrain& above);

}  // namespace rubicon::soil
