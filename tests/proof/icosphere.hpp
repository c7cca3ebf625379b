#pragma once

#include "src/motion/geometry/shape.hpp"

namespace rubicon::collision::proof {

/// The unit sphere as a closed mesh: an icosahedron whose triangles are cut into four `fineness`
/// times, corners pushed out to the sphere.
geometry::TriangleMesh icosphere(int fineness);

/// The one of 42 corners, made once.
const geometry::TriangleMesh& icosphere42();
/// The radius of the greatest ball about the origin inside it.
double icosphere42_inner_radius();

}  // namespace rubicon::collision::proof
