#pragma once

#include <optional>

#include "src/motion/collision/sweep/body.hpp"

namespace rubicon::collision {

/// When and where two bodies first get deeper than the contact tolerance into each other while `a`
/// and `b` move, containment included; nothing where they stay free of each other.
std::optional<Contact> body_contact(const Body& a, const Motion& motion_a, const Body& b,
                                    const Motion& motion_b, double contact_tolerance);

}  // namespace rubicon::collision
