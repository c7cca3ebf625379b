#pragma once

#include <vector>

#include "src/motion/collision/convex/convex.hpp"
#include "src/motion/collision/mesh/triangle_soup.hpp"

namespace rubicon::collision {

/// What a mesh is tested as: its convex closed parts as solids, everything else as triangles.
struct MeshParts {
  std::vector<ConvexPiece> convex;
  std::vector<TriangleSoup> soups;
};

/// Splits a mesh (indices valid, coordinates finite) into its parts. A closed part is taken as
/// convex when all its corners lie on one side of every face; not where the mesh has cavities
/// (parts turned inside out) and not beyond some hundred corners, where the triangles with their
/// tree are quicker.
MeshParts split_mesh(const std::vector<Vec3>& vertices,
                     const std::vector<TriangleSoup::Triangle>& triangles, bool closed);

}  // namespace rubicon::collision
