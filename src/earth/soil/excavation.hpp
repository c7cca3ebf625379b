#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/earth/soil/terrain.hpp"

namespace rubicon::soil {

/// What is to be dug: a simple polygon in the plan view of {E} (m, either sense), down to a height.
struct Pit {
  std::vector<Eigen::Vector2d> outline;
  Millimetres bottom = 0;
};

struct Excavation {
  Terrain after;
  CubicMillimetres volume = 0;      ///< that is taken away, whole
  CubicMillimetres in_outline = 0;  ///< of it
  int cells = 0;                    ///< that are lower than before
  /// The slopes meet the border of the terrain: what lies beyond would fall in.
  bool reaches_border = false;
};

/// Digs the pit: each cell whose middle is in the outline goes down to the bottom; outside of it no
/// cell stays higher than the bottom and what a slope of `stands_deg` (above 0, up to 90: upright
/// walls) from the outline to its middle allows. What is lower already stays as it is.
Excavation excavate(const Terrain& terrain, const Pit& pit, double stands_deg);

}  // namespace rubicon::soil
