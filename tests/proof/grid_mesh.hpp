#pragma once

#include "src/motion/geometry/shape.hpp"
#include "tests/proof/grid_solid.hpp"

namespace rubicon::collision::proof {

/// How the surface of a grid solid is cut into triangles.
struct GridMeshStyle {
  bool merged = true;   ///< faces of cells are joined to larger rectangles
  int quarterings = 0;  ///< times each triangle is cut into four
  int slivers = 0;      ///< triangles that are cut into three, often very thin ones
  double noise = 0;     ///< m, of every coordinate
};
GridMeshStyle random_style(Random& random);

/// The closed surface of a solid; corners are shared, so it has no gaps.
geometry::TriangleMesh grid_mesh(const GridSolid& solid, const GridMeshStyle& style,
                                 Random& random);

/// The least altitude (m) of its triangles.
double finest_altitude(const geometry::TriangleMesh& mesh);

}  // namespace rubicon::collision::proof
