#pragma once

#include <span>
#include <vector>

#include "src/motion/travel/outline.hpp"

namespace rubicon::travel {

/// Where a straight way out of obstacles ends: on an outline, a few micrometres outside.
struct Exit {
  Vec2 place{0, 0};     ///< on the lattice, in free space
  double distance = 0;  ///< m, straight
  int composite = 0;    ///< whose outline it is on
  int loop = 0;
};

/// Straight ways from a place that obstacles cover into free space, the shortest first: to the
/// nearest point of each of the nearest edges of the outlines, and in given directions (of length
/// 1) to where they first lead out. None: the place is not covered. What stands on the way is not
/// looked at.
std::vector<Exit> exits_of(const Outline& outline, const Vec2& place,
                           std::span<const Vec2> directions);

}  // namespace rubicon::travel
