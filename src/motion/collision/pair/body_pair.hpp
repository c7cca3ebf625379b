#pragma once

#include "src/motion/collision/sweep/body.hpp"

namespace rubicon::collision {

/// Whether two bodies get deeper than the contact tolerance into each other while `a` and `b` move,
/// containment included.
bool bodies_blocked(const Body& a, const Motion& motion_a, const Body& b, const Motion& motion_b,
                    double contact_tolerance);

}  // namespace rubicon::collision
