#pragma once

#include <array>
#include <vector>

#include "src/verify/scene.hpp"

namespace rubicon::gltf {

using math::Pose;
using math::Vec3;

/// Counter-clockwise seen from outside; metres.
using Triangle = std::array<Vec3, 3>;

/// The surfaces of shapes as triangles in the frame of their body. Round ones are cut into facets
/// whose corners lie on the surface. Triangles without area are left out. Throws
/// verify::UnreadableInput for a polygon that crosses itself.
std::vector<Triangle> triangles_of(const std::vector<verify::ShapeData>& shapes,
                                   const std::vector<verify::MeshData>& meshes);

}  // namespace rubicon::gltf
