#pragma once

#include <vector>

#include "src/collision/bounds.hpp"
#include "src/collision/swept_query.hpp"

namespace rubicon::collision {

/// A body that stands at X_WB.
struct StandingPart {
  BodyPtr body;
  Pose X_WB = Pose::Identity();
};

/// The whole volume a body sweeps in a motion, as bodies that stand: never less than it, and more
/// by at most `growth` (m) as far as `kMaxSlices` slices allow; exact for translations. Who is in
/// the way of these bodies is judged by the widths of the body's own pieces. The body must be owned
/// by a BodyPtr. Throws std::invalid_argument for motions that are not valid. docs/collision.md,
/// Other machines.
std::vector<StandingPart> swept_volume(const Body& body, const Motion& motion, double growth);

/// The box around everything the body sweeps, world.
Bounds swept_bounds(const Body& body, const Motion& motion);

}  // namespace rubicon::collision
