#pragma once

#include "bench/near_steps.hpp"

namespace rubicon::bench {

/// What makes the steps among the meshes.
enum class MeshLoad { kBox, kMesh };

/// `count` rigid instances of three closed meshes that are not convex, of about 1,000 triangles
/// each (a corrugated panel, a boulder, a ring), at constant density, turned every way.
SweptScene mesh_scene(int count, StepKind kind, MeshLoad load);

}  // namespace rubicon::bench
