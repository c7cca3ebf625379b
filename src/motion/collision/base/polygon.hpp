#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubicon::collision {

using Polygon = std::vector<Eigen::Vector2d>;

/// Positive where b is to the left of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A simple polygon ready to be split: counter-clockwise, without repeated corners or corners on a
/// straight side. Throws std::invalid_argument where it is not finite, has no area, or crosses or
/// touches itself.
Polygon simple_polygon(const Polygon& polygon);

/// Splits a polygon from `simple_polygon` into convex counter-clockwise parts with the same corners
/// that cover it exactly: ears (Meisters 1975), then diagonals taken out where both ends stay
/// convex (Hertel, Mehlhorn 1983).
std::vector<Polygon> convex_parts(const Polygon& polygon);

}  // namespace rubicon::collision
