#pragma once

#include <vector>

#include "src/motion/collision/mesh/triangle_soup.hpp"

namespace rubicon::collision {

/// Winding number of a closed soup about a point that is not on its surface: 0 outside, 1 inside a
/// well-oriented solid. Signed crossings along a ray (another ray where one grazes an edge), the
/// sum of solid angles if all rays graze.
int winding_number(const TriangleSoup& soup, const Vec3& point);

/// Whether a point is within `distance` (m) of the surface.
bool surface_within(const TriangleSoup& soup, const Vec3& point, double distance);

/// How far (m) it is from a point along a unit vector to each place where the ray meets the
/// surface, in order; the point's own place left out, places that are next to each other taken
/// once, none farther than `reach` (m).
std::vector<double> ways_to_surface(const TriangleSoup& soup, const Vec3& from,
                                    const Vec3& direction, double reach);

}  // namespace rubicon::collision
