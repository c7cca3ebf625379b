#pragma once

#include <vector>

#include "src/motion/coverage/grid.hpp"

namespace rubicon::coverage {

/// A connected part of the plane: an outline and the holes in it, all counter-clockwise, each
/// beginning at its least corner.
struct Region {
  Ring outline;
  std::vector<Ring> holes;
};

/// Twice the area of a region in square units.
std::int64_t twice_area(const Region& region);

/// What lies in any of the rings, of either sense. Gaps narrower than `gap` (units) are closed;
/// acute corners lose up to that. Regions by their least corner.
std::vector<Region> united(const std::vector<Ring>& rings, std::int64_t gap = 0);
/// What lies in an odd number of rings: a ring in a ring is a hole.
std::vector<Region> nested(const std::vector<Ring>& rings);
/// What of the regions lies in none of the rings.
std::vector<Region> difference(const std::vector<Region>& regions, const std::vector<Ring>& rings);

/// What of the rings lies in the outline of a region, `inset` units or more from it.
std::vector<Region> inside_outline(const std::vector<Ring>& rings, const Region& region,
                                   std::int64_t inset);

// Found by the library Clipper (A. Johnson), on the grid: corners of crossings are rounded to it.

}  // namespace rubicon::coverage
