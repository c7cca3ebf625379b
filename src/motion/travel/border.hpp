#pragma once

#include <vector>

#include "src/motion/travel/exact.hpp"

namespace rubicon::travel {

/// Places p of the plan view with normal . p <= most, m; the normal has the length 1.
struct HalfPlane {
  Vec2 normal{1, 0};
  double most = 0;

  double beyond(const Vec2& p) const { return normal.dot(p) - most; }
};

/// Convex polygons that lie like a frame round the places of a rectangle that are in all half
/// planes; none: there are no such places.
std::vector<std::vector<Vec2>> border_of(const std::vector<HalfPlane>& bounds, const Vec2& low,
                                         const Vec2& high);

}  // namespace rubicon::travel
