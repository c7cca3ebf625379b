#pragma once

#include <array>
#include <span>
#include <vector>

#include "src/motion/collision/base/bounds.hpp"

namespace rubicon::collision {

/// How far a body reaches along a unit direction n: the least and the greatest n.p over its points
/// (m).
struct Interval {
  double least = 0;
  double greatest = 0;
};

/// A convex solid seen through its support function, in the frame of its body: the hull of
/// `vertices` (the core), each carrying a flat disc of radius `disc` across `disc_axis` (a cylinder
/// is two such vertices) and grown by a ball of radius `ball` (sphere, capsule). `normals` and
/// `edges` are the distinct face normals and edge directions of the core, unit vectors up to sign:
/// what separating axes are made of.
struct Convex {
  std::span<const Vec3> vertices;
  std::span<const Vec3> normals;
  std::span<const Vec3> edges;
  double ball = 0;
  double disc = 0;
  Vec3 disc_axis = Vec3::UnitZ();
  Bounds bounds;  ///< around everything, ball and disc included
  double width =
      0;  ///< the smallest extent of the shape it belongs to, for the tolerance of thin things

  /// Point of the core (disc included, ball not) farthest along the unit vector n.
  Vec3 core_support(const Vec3& n) const;
  /// Extent along the unit vector n, ball included; exact but for rounding.
  Interval extent(const Vec3& n) const;
  /// Greatest distance of a core point from the line through `point` along the unit vector `axis`;
  /// the ball, which a rotation does not change, is left out, and so is a disc across a parallel
  /// axis.
  double radius_about(const Vec3& axis, const Vec3& point) const;
};

/// A `Convex` with its storage.
class ConvexPiece {
 public:
  std::vector<Vec3> vertices;
  std::vector<Vec3> normals;
  std::vector<Vec3> edges;
  double ball = 0;
  double disc = 0;
  Vec3 disc_axis = Vec3::UnitZ();
  double width = 0;
  Bounds bounds;

  /// A view that lives as long as this piece stays where it is.
  Convex view() const;
  /// Sets `bounds` from the rest.
  void update_bounds();
};

/// A triangle as a flat convex solid, with its own storage; degenerate triangles must be dropped
/// before.
class TrianglePiece {
 public:
  TrianglePiece(const Vec3& a, const Vec3& b, const Vec3& c);
  TrianglePiece(const TrianglePiece&) = delete;
  TrianglePiece& operator=(const TrianglePiece&) = delete;

  const Convex& view() const { return view_; }

 private:
  std::array<Vec3, 3> vertices_;
  std::array<Vec3, 1> normal_;
  std::array<Vec3, 3> edges_;
  Convex view_;
};

/// The smallest altitude of a triangle (m); 0 where two vertices coincide.
double smallest_altitude(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace rubicon::collision
