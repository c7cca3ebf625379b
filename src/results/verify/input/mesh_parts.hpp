#pragma once

#include <array>
#include <vector>

#include "src/results/verify/input/convex.hpp"
#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// A mesh, cut into what can be tested: convex solids, and what is left as triangles.
struct MeshParts {
  std::vector<Convex> solids;
  std::vector<Convex> triangles;
  std::vector<Vec3> vertices;                   ///< of what is left
  std::vector<std::array<int, 3>> closed_rest;  ///< triangles that enclose a volume, if they do
};

/// Closed parts that are convex become solids, unless the mesh has cavities. The frame is the
/// mesh's own.
MeshParts parts_of(const MeshData& mesh);

}  // namespace rubicon::verify
