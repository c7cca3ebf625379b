#pragma once

#include <optional>

#include "src/collision/body.hpp"

namespace rubicon::collision {

/// Winding number of a closed soup about a point that is not on its surface: 0 outside, 1 inside a
/// well-oriented solid. Signed crossings along a ray (another ray where one grazes an edge), the
/// sum of solid angles if all rays graze.
int winding_number(const TriangleSoup& soup, const Vec3& point);

/// Whether a point lies inside a closed soup, farther than `depth` (m) from its surface. Never true
/// for an open one.
bool deep_inside(const TriangleSoup& soup, const Vec3& point, double depth);

/// A probe point of one body that is deeper than the contact tolerance in a closed mesh of the
/// other, in B's centred coordinates: what surfaces that do not cross cannot tell. `a_in_b` places
/// A's centred coordinates in B's. Solid pieces need no such test.
std::optional<Vec3> contained_point(const Body& a, const Body& b, const Placement& a_in_b,
                                    double contact_tolerance);

/// Whether there is one.
bool contained(const Body& a, const Body& b, const Placement& a_in_b, double contact_tolerance);

}  // namespace rubicon::collision
