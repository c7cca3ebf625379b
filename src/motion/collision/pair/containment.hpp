#pragma once

#include <optional>

#include "src/motion/collision/sweep/body.hpp"

namespace rubicon::collision {

/// A probe point of one body that is deeper than the contact tolerance (less for what is thin) in a
/// closed mesh of the other, in B's centred coordinates: what surfaces that do not cross cannot
/// tell. `a_in_b` places A's centred coordinates in B's. Solid pieces need no such test.
std::optional<Vec3> contained_point(const Body& a, const Body& b, const Placement& a_in_b,
                                    double contact_tolerance);

/// Whether there is one.
bool contained(const Body& a, const Body& b, const Placement& a_in_b, double contact_tolerance);

/// Looks at some of the points that `contained` looks at, quickly. True is certain: `contained`
/// says so too. False says nothing.
bool surely_contained(const Body& a, const Body& b, const Placement& a_in_b,
                      double contact_tolerance);

}  // namespace rubicon::collision
