#pragma once

#include <vector>

#include "src/motion/collision/convex/convex.hpp"
#include "src/motion/geometry/shape.hpp"

namespace rubicon::collision {

/// The convex pieces of a solid in the frame `X` of its body; their union is the solid. Throws
/// std::invalid_argument for geometry that is not finite or has no extent.
std::vector<ConvexPiece> pieces_of(const geometry::Box& box, const Placement& X);
std::vector<ConvexPiece> pieces_of(const geometry::Cylinder& cylinder, const Placement& X);
std::vector<ConvexPiece> pieces_of(const geometry::Sphere& sphere, const Placement& X);
std::vector<ConvexPiece> pieces_of(const geometry::Capsule& capsule, const Placement& X);
std::vector<ConvexPiece> pieces_of(const geometry::Prism& prism, const Placement& X);

/// Appends a direction unless it is there already, either way round (`kSameDirection`).
void add_direction(std::vector<Vec3>& directions, const Vec3& direction);

/// Sets a polytope's width to its smallest extent along its face normals, and its bounds.
void finish_polytope(ConvexPiece& piece);

}  // namespace rubicon::collision
