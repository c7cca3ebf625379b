#pragma once

#include <memory>
#include <vector>

#include "src/motion/geometry/shape.hpp"
#include "src/simulation/trace/json_object_simdjson.hpp"

namespace rubicon::trace {

using HeaderMeshes = std::vector<std::shared_ptr<const geometry::TriangleMesh>>;

/// The member `meshes` of a header; throws as JsonObject does.
HeaderMeshes read_meshes(const JsonObject& header);

/// A list of shapes; throws as JsonObject does.
std::vector<geometry::Shape> read_shapes(const JsonObject& object, std::string_view name,
                                         const HeaderMeshes& meshes);

}  // namespace rubicon::trace
