#pragma once

#include "src/motion/collision/convex/swept_pair.hpp"

namespace rubicon::collision {

/// Whether a direction exists along which the pair overlaps by at most its tolerance over the whole
/// interval: proof that the interval is free. For one pose or a translation, false means a hit
/// (exactly so for polytopes, to far below 0.1 mm for round shapes); for a rotation or a general
/// motion it means undecided.
bool separated(const SweptPair& pair);

}  // namespace rubicon::collision
