#pragma once

#include <vector>

#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// A figure of a way, and by how much what is told of it may differ.
struct WayFigure {
  double value = 0;
  double slack = 0;

  bool fits(double told) const;
};

/// What a way is like (docs/guides.md), from its points and the header alone.
struct WayFigures {
  WayFigure roughness;    ///< change of direction, summed over the points
  WayFigure length;       ///< m that each parameter moves the tool by itself, summed
  WayFigure motion_time;  ///< s at full speed, the slowest of each leg
};

/// `way`: configurations with all parameters; `turn_radius` of its guide, m, 0: none.
WayFigures way_figures(const SceneRobot& robot, const std::vector<std::vector<double>>& way,
                       bool loaded, double turn_radius);

}  // namespace rubicon::verify
