#pragma once

#include <span>
#include <vector>

#include "src/motion/travel/outline.hpp"

namespace rubicon::travel {

/// Corners of the regular polygon round a disc about the origin, counter-clockwise, m: one side is
/// tangent in the east. It reaches beyond the disc by at most radius (1 / cos(180 / sides) - 1),
/// 0.49 per cent of the radius with 32 sides. Radius positive, at least 3 sides, else
/// std::invalid_argument.
std::vector<Vec2> disc(double radius, int sides = 32);

/// Where the reference point of a robot may not be: a convex obstacle grown by a convex footprint,
/// whose corners are given about the reference point. This is the Minkowski sum of the obstacle and
/// the mirrored footprint (Lozano-Perez and Wesley 1979). Corners counter-clockwise, m.
std::vector<Vec2> grow(std::span<const Vec2> obstacle, std::span<const Vec2> footprint);

/// Triangles whose union is a ring: what is grown part by part where an obstacle is not convex.
/// Ears are cut off (Meisters 1975), with exact predicates.
std::vector<Ring> convex_parts(Ring ring);

/// The pieces of an obstacle of any simple shape, grown by a convex footprint.
std::vector<Piece> grown_pieces(std::span<const Vec2> corners, std::span<const Vec2> footprint,
                                int obstacle);

}  // namespace rubicon::travel
