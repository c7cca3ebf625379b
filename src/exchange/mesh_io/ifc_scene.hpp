#pragma once

#include <string_view>

#include "src/exchange/mesh_io/file_scene.hpp"
#include "src/exchange/mesh_io/scene_wire.hpp"

namespace rubicon::mesh_io {

/// How the text of an IFC file is to be understood.
struct IfcQuery {
  /// The numbers as they are written (z up), not turned to y up.
  bool ignore_declared_up = false;
  SceneLimits limits;
};

/// The triangles of an IFC file (2x3, 4 or 4.3), a node an element, below the storeys and buildings
/// it belongs to. They come from element_bodies(), and of what that cannot read from assimp, which
/// gets plain_ifc(); where the element stands is worked out here, in double precision. Runs in the
/// helper program alone. The failure is for people.
SceneMessage read_ifc(std::string_view text, const IfcQuery& query);

}  // namespace rubicon::mesh_io
