#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubicon::gltf {

using Polygon = std::vector<Eigen::Vector2d>;

/// A simple polygon cut into convex ones with the same corners: ears are cut off, then neighbours
/// are joined again where the whole stays convex (Hertel and Mehlhorn, Fast triangulation of simple
/// polygons, 1983). Throws std::invalid_argument if the polygon is not simple.
std::vector<Polygon> convex_parts(const Polygon& polygon);

}  // namespace rubicon::gltf
