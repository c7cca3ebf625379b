#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/exchange/mesh_io/scene_wire.hpp"

namespace rubicon::mesh_io {

/// Points as bytes for a job of the helper; both ends run on the same machine.
std::string encode_points(const std::vector<math::Vec3>& points);

/// The triangles of the convex hull of points that encode_points() wrote, as a scene of one node:
/// its corners are points of the input, bit for bit. Or why there is no hull, for people. By the
/// Quickhull algorithm (Barber, Dobkin, Huhdanpaa 1996) of the library qhull, whose facets are not
/// exact: whoever uses the result verifies it (see hull_contains). Runs in the helper's child.
SceneMessage hull_of_points(std::string_view bytes);

}  // namespace rubicon::mesh_io
