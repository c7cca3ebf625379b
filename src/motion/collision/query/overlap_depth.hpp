#pragma once

#include "src/motion/collision/swept_query.hpp"

namespace rubicon::collision {

/// How deep two standing bodies are in each other (m), 0 where they are not: the most that any
/// piece of one would have to be pushed to be out of a piece of the other, whatever the direction.
/// Pieces are the convex ones of docs/collision.md; triangles of meshes are flat, and what is
/// inside a closed mesh counts by how far below its surface it is known to be, so that of meshes it
/// is a least depth.
double overlap_depth(const Body& a, const Pose& X_WA, const Body& b, const Pose& X_WB);

}  // namespace rubicon::collision
