#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::gltf {

using math::Pose;
using math::Vec3;

/// A document has no more triangles than this: they take 700 MB, and its length is written in 32
/// bits.
inline constexpr std::size_t kMostTriangles = 10'000'000;

/// Counter-clockwise seen from outside; metres.
using Triangle = std::array<Vec3, 3>;

/// The surfaces of shapes as triangles in the frame of their body. Round ones are cut into facets
/// whose corners lie on the surface. Triangles without area are left out. Throws
/// std::invalid_argument for a solid without extent, a polygon that crosses itself, or more than
/// `most`.
std::vector<Triangle> triangles_of(const std::vector<geometry::Shape>& shapes,
                                   std::size_t most = kMostTriangles);

}  // namespace rubicon::gltf
