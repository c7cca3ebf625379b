#pragma once

#include <span>

#include "src/motion/coverage/floor.hpp"

namespace rubicon::coverage {

/// A place of the way; `working` and `heading_deg` tell of the stretch that leads to it (of the
/// first one: of the stretch that leaves it). The heading is counted from x towards y.
struct WayPoint {
  Place place;
  double heading_deg = 0;
  bool working = false;
};

/// What a way does, found from its polyline and the description of the floor alone.
struct Measures {
  /// Share of the reachable floor that was worked over, 0 to 1. The tool is a line of `width`
  /// across its travel; floor is the slab without shafts and columns; reachable is what lies within
  /// width/2 in x and in y of an allowed place of the tool, which is one on the slab, in x or in y
  /// `clearance` or more from every shaft and column. Exact where floor and lines are parallel to
  /// the axes and columns are square; else found along lines 1/40 of the width apart.
  double coverage = 0;
  double length = 0;          ///< m; with travel
  double working_length = 0;  ///< m
  int turns = 0;              ///< changes of heading by more than one degree
  double inside_holes = 0;    ///< m; of the way, nearer to a shaft or column than the clearance
  double outside = 0;         ///< m; of the way, outside the outline
  double reachable_area = 0;  ///< m2
  double floor_area = 0;      ///< m2; slab less shafts and columns
  double lower_bound = 0;     ///< m; reachable area over width: no way that covers it is shorter
};

/// How far a way may be off before it counts, and how much wider the tool counts as: what rounding
/// to the grid and turning a floor there and back can make, m.
inline constexpr double kMeasureTolerance = 0.0005;

/// The measures of a way over a floor without faults.
Measures measure(const FloorDescription& floor, const CoverageOptions& options,
                 std::span<const WayPoint> way);

}  // namespace rubicon::coverage
