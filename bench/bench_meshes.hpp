#pragma once

#include <memory>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::bench {

using MeshPtr = std::shared_ptr<const geometry::TriangleMesh>;

/// Closed meshes about their origin, triangles outwards, none of them convex.

/// A corrugated panel 3 m x 2.6 m, 0.15 m thick: 1,008 triangles.
MeshPtr corrugated_panel();
/// A boulder of about 1.2 m radius: 992 triangles.
MeshPtr boulder();
/// A ring of radius 1.2 m, 0.3 m thick: 1,024 triangles.
MeshPtr ring();

}  // namespace rubicon::bench
