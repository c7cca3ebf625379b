#pragma once

#include "src/collision/body.hpp"

namespace rubicon::collision {

/// Whether two bodies get deeper than the contact tolerance into each other while `a` and `b` move,
/// containment included.
bool bodies_blocked(const Body& a, const Motion& motion_a, const Body& b, const Motion& motion_b,
                    double contact_tolerance);

/// The box around everything `body` sweeps, world; infinite where a motion cannot bound itself.
Bounds swept_bounds(const Body& body, const Motion& motion);

}  // namespace rubicon::collision
