#pragma once

#include <map>

#include "src/earth/soil/terrain.hpp"

namespace rubicon::soil {

/// What a load does to the surface that it is tipped on.
struct HeapGrowth {
  std::map<int, Millimetres> heights;  ///< cells that are higher than before
  bool reaches_border = false;         ///< it would fall over the border of the terrain
};

/// Tips `units` of soil over the middle of a cell, each as much as 1 mm of a cell. It lies as a
/// cone of that slope on what was there: no higher at a cell than the slope allows, down from one
/// place. Exact: its cells rise by `units` mm in all. What is left over for a whole mm all round
/// lies on the cells nearest to the middle, of equals the first. So it is steeper than the slope by
/// 2 mm from cell to cell at most. Units: 1 and more.
HeapGrowth tip_over(const Terrain& surface, int cell, std::int64_t units, double repose_deg);

}  // namespace rubicon::soil
