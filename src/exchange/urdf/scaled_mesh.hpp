#pragma once

#include <string>

#include "src/exchange/urdf/machine.hpp"
#include "src/motion/geometry/shape.hpp"

namespace rubicon::urdf {

/// The text of an OBJ file: the mesh with its axes multiplied by three factors. A mirrored one
/// keeps its triangles facing outwards.
std::string scaled_mesh_text(const geometry::TriangleMesh& mesh, const Triple& scale);

}  // namespace rubicon::urdf
