#pragma once

#include <optional>
#include <vector>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::geometry {

/// What a solid holds.
struct Volume {
  double volume = 0;           ///< m3
  Vec3 centre = Vec3::Zero();  ///< its centroid, in the frame of the body (m)
};

/// Of one shape, in closed form; of a closed mesh by the tetrahedra between its triangles and a
/// point (Mirtich 1996, Fast and accurate computation of polyhedral mass properties, section 4).
/// Nothing for a mesh that is not closed.
std::optional<Volume> volume_of(const Shape& shape);

/// Of all of them together; where they overlap it counts twice. Nothing if one has none, or there
/// is no shape.
std::optional<Volume> volume_of(const std::vector<Shape>& shapes);

}  // namespace rubicon::geometry
