#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "src/motion/guides/guide.hpp"
#include "src/motion/guides/space.hpp"

namespace rubicon::guides {

/// A coordinate of a space, cut into cells from `low` to `high` (m or degrees).
struct GridAxis {
  std::size_t coordinate = 0;
  double low = 0;
  double high = 1;
  int cells = 1;

  double middle(int cell) const { return low + (cell + 0.5) / cells * (high - low); }
};

/// To each cell that two coordinates span whether the robot may not stand at its middle, all others
/// as in `point`: along the first of them, row by row from below.
std::vector<bool> blocked_cells(Space& space, Point point, const std::array<GridAxis, 2>& axes);

/// Where a robot may not stand about what a guide searched through: configurations that two of its
/// parameters span, in layers for values of a third, all others as where the search began.
struct ForbiddenGrid {
  std::vector<int> parameters;  ///< of the robot: across, up and, where there are layers, the third
  std::array<double, 2> low = {}, high = {};  ///< of the first two (m, degrees)
  std::array<int, 2> cells = {};
  std::vector<double> layers;  ///< values of the third, ascending; none: there is one layer
  std::vector<double> q;       ///< where the search began: all parameters
  std::vector<bool> blocked;   ///< layer by layer, each as of `blocked_cells`
};

/// Of the parameters that a search and its way changed most, or of a vehicle its place and its
/// heading, as far as they went and somewhat beyond. Tests each cell once. None: no leg changes two
/// parameters, or its values are no numbers.
std::optional<ForbiddenGrid> sample_forbidden(const GuideSpec& spec, const GuideTask& task,
                                              std::span<const double> q, const PlanReport& report,
                                              MotionTests& tests);

}  // namespace rubicon::guides
