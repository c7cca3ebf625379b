#pragma once

#include <vector>

#include "src/results/verify/input/json_fields.hpp"
#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// The `meshes` of a header; throws UnreadableInput on indices out of range.
std::vector<MeshData> read_meshes(const Json& list);

/// A list of shapes; `meshes` is how many meshes there are. Throws UnreadableInput on shapes
/// without extent.
std::vector<ShapeData> read_shapes(const Json& list, std::size_t meshes);

}  // namespace rubicon::verify
