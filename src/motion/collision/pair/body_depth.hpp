#pragma once

#include "src/motion/collision/swept_query.hpp"

namespace rubicon::collision {

/// How deep two bodies overlap at a share of their motions (m): the greatest depth of any two of
/// their pieces, known to kDepthResolution and never said too great; triangles of meshes are flat
/// pieces. 0 where the surfaces do not overlap, also for a body wholly inside a mesh. Throws
/// std::invalid_argument for motions that are not valid, and shares beyond 0 to 1.
double body_depth(const MovingBody& a, const MovingBody& b, double fraction);

/// m.
inline constexpr double kDepthResolution = 1e-6;

}  // namespace rubicon::collision
