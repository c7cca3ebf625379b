#pragma once

#include <cstddef>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::verify {

using math::Pose;
using math::Vec3;

/// More directions of faces and edges together make the test by axes slower than the general one.
inline constexpr std::size_t kMostDirections = 40;

/// A convex solid, or a flat triangle: the hull of its corners, grown by a ball, each corner by a
/// disc across an axis. Metres, in the frame of its body.
struct Convex {
  std::vector<Vec3> corners;
  double ball = 0;  ///< radius
  double disc = 0;  ///< radius
  Vec3 disc_axis = Vec3::UnitZ();
  /// Of what has corners only: unit normals of the faces and directions of the edges, opposite ones
  /// once. Empty: too many, or round.
  std::vector<Vec3> normals;
  std::vector<Vec3> edges;
  double width = 0;  ///< smallest extent; of a triangle its smallest altitude

  bool has_axes() const { return !normals.empty(); }
  /// The point farthest along n.
  Vec3 support(const Vec3& n) const;
  Vec3 centre() const;
};

/// m: boxes are grown by it so that rounding hides no pair.
inline constexpr double kBoundsMargin = 1e-6;

/// An axis-parallel box.
struct Bounds {
  Vec3 lower = Vec3::Constant(1e300);
  Vec3 upper = Vec3::Constant(-1e300);

  void add(const Vec3& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  void add(const Bounds& other) {
    lower = lower.cwiseMin(other.lower);
    upper = upper.cwiseMax(other.upper);
  }
  bool meets(const Bounds& other) const {
    return (lower.array() <= other.upper.array()).all() &&
           (other.lower.array() <= upper.array()).all();
  }
  Vec3 centre() const { return (lower + upper) / 2; }
  Bounds grown(double by) const;
  /// Round the box where X puts it.
  Bounds placed(const Pose& X) const;
};

Bounds bounds_of(const Convex& piece);

/// A box, a triangle, and the hull of a convex polygon from z0 to z1 (corners in order, either way
/// round).
Convex box_piece(const Vec3& lower, const Vec3& upper);
Convex triangle_piece(const Vec3& a, const Vec3& b, const Vec3& c);
Convex prism_piece(const std::vector<Eigen::Vector2d>& polygon, double z0, double z1);
Convex cylinder_piece(double radius, double z0, double z1);
/// All points within `radius` of the segment a-b.
Convex capsule_piece(const Vec3& a, const Vec3& b, double radius);

/// The piece, placed by X in the frame of its body.
Convex placed(Convex piece, const Pose& X);

}  // namespace rubicon::verify
