#pragma once

#include "src/collision/triangle_soup.hpp"

namespace rubicon::collision {

/// Winding number of a closed soup about a point that is not on its surface: 0 outside, 1 inside a
/// well-oriented solid. Signed crossings along a ray (another ray where one grazes an edge), the
/// sum of solid angles if all rays graze.
int winding_number(const TriangleSoup& soup, const Vec3& point);

/// Whether a point is within `distance` (m) of the surface.
bool surface_within(const TriangleSoup& soup, const Vec3& point, double distance);

/// How far (m) it is from a point of the surface of a closed soup along a unit vector, which points
/// into the solid, to where the solid ends; infinite where that is not found. Where the ray grazes
/// an edge it may be too far.
double way_out(const TriangleSoup& soup, const Vec3& from, const Vec3& direction);

}  // namespace rubicon::collision
