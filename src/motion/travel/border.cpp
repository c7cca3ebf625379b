#include "src/motion/travel/border.hpp"

namespace rubicon::travel {
namespace {

/// m.
constexpr double kBorderWidth = 1;
/// m; shorter sides are corners.
constexpr double kShortestSide = 1e-5;

/// What of a convex polygon lies in a half plane.
std::vector<Vec2> cut(const std::vector<Vec2>& polygon, const HalfPlane& bound) {
  std::vector<Vec2> rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    const double at_a = bound.beyond(a);
    const double at_b = bound.beyond(b);
    if (at_a <= 0) rest.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) {
      rest.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
  }
  return rest;
}

}  // namespace

std::vector<std::vector<Vec2>> border_of(const std::vector<HalfPlane>& bounds, const Vec2& low,
                                         const Vec2& high) {
  std::vector<Vec2> inner{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  for (const HalfPlane& bound : bounds) inner = cut(inner, bound);
  std::vector<std::vector<Vec2>> border;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const Vec2 side = inner[(i + 1) % inner.size()] - inner[i];
    if (side.norm() < kShortestSide) continue;
    const Vec2 along = kBorderWidth * side.normalized();
    const Vec2 outwards(along.y(), -along.x());
    // Longer than the side, so that those of neighbours overlap.
    const Vec2 from = inner[i] - along;
    const Vec2 to = inner[i] + side + along;
    border.push_back({from, to, to + outwards, from + outwards});
  }
  return border;
}

}  // namespace rubicon::travel
