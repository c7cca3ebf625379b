#pragma once

#include <vector>

#include "src/motion/coverage/floor.hpp"

namespace rubicon::coverage {

/// A grid of holes over a floor, and a short way from one to the next.
struct HolePattern {
  struct Stop {
    Place place;
    bool is_hole = false;  ///< else a corner of the way round a shaft or a column
  };
  std::vector<Stop> way;
  int holes = 0;
  int left_out = 0;  ///< places of the grid in the outline where the tool may not be
};

/// Holes `apart` along x and along y, in the middle of the box round the outline, so that each has
/// at least half of that to its sides. Of the options `clearance`, `from` and `tries` count. The
/// order is there and back by rows, then 2-opt and or-opt; ways between are the shortest allowed
/// ones. A hole that no allowed way leads to is left out. Throws std::invalid_argument with the
/// first fault of the input. The same input gives the same way, bit for bit.
HolePattern plan_holes(const FloorDescription& floor, const CoverageOptions& options,
                       const Place& apart);

/// More places of a grid are refused: the way would be empty, `left_out` counts them.
inline constexpr std::int64_t kMostHoles = 5'000;

}  // namespace rubicon::coverage
