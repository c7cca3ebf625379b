#pragma once

#include "src/motion/collision/convex/gjk.hpp"

namespace rubicon::collision {

/// For cores that meet: whether some direction shows an overlap of at most the tolerance. Grows a
/// polytope inside the difference set towards the boundary nearest to the origin (van den Bergen
/// 2001, Proximity queries and penetration depth computation on 3D game objects). True is proved by
/// the support functions; false means that a ball larger than the tolerance fits around the origin,
/// or that rounding or the round limit leaves it undecided.
bool shallow_direction_exists(const SweptPair& pair, const Simplex& simplex);

}  // namespace rubicon::collision
