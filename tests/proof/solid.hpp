#pragma once

#include <vector>

#include "src/motion/geometry/shape.hpp"
#include "tests/proof/fcl_voice.hpp"
#include "tests/proof/polytope.hpp"

namespace rubicon::collision::proof {

/// A convex solid as all parties see it: engine, exact oracle (if a polytope) and FCL.
struct Solid {
  enum class Kind { kBox, kPrism, kSphere, kCapsule, kCylinder };

  Kind kind = Kind::kBox;
  Vec3 half = Vec3::Constant(0.5);       ///< box: half extents; prism: half height in z
  double radius = 0.5;                   ///< round ones
  double half_length = 0.5;              ///< capsule (its segment) and cylinder, along z
  std::vector<Eigen::Vector2d> polygon;  ///< prism: convex, counter-clockwise, about the origin

  bool is_polytope() const { return kind == Kind::kBox || kind == Kind::kPrism; }
  geometry::Shape shape() const;
  Polytope polytope() const;  ///< polytopes only
  /// Greatest distance of a point from the origin (m).
  double reach() const;
  double width() const;
  /// For FCL: all points within `grow` m of the solid and perhaps some more; for a negative number
  /// only points that deep inside it and perhaps not all; null if nothing is left.
  FclGeometry fcl(double grow = 0) const;
};

Solid box_solid(const Vec3& half);
/// A prism over a random convex polygon of 3 to 8 corners.
Solid random_prism(Random& random, double size);
/// Any kind.
Solid random_solid(Random& random, double least, double greatest);
/// Kind and sizes with all digits.
std::string text_of(const Solid& solid);

}  // namespace rubicon::collision::proof
