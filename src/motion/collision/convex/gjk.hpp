#pragma once

#include <array>
#include <limits>

#include "src/motion/collision/convex/swept_pair.hpp"

namespace rubicon::collision {

/// Cores nearer than this (m) touch: the direction between them is noise. Their depth is left to
/// the expanding polytope.
inline constexpr double kTouching = 1e-10;

/// Points of the difference set of a pair's cores: the last simplex of a search.
struct Simplex {
  std::array<Vec3, 4> points;
  int size = 0;
};

/// The point of a simplex nearest to the origin, and which of its corners it lies between.
struct Closest {
  Vec3 point = Vec3::Zero();
  double distance_squared = std::numeric_limits<double>::infinity();
  std::array<int, 4> kept{};
  int size = 0;
};

/// Every vertex, edge and face is looked at, which is slower and safer than walking; the inside of
/// a tetrahedron is not.
Closest closest_to_origin(const Simplex& simplex);

/// Whether the origin lies inside a tetrahedron.
bool encloses_origin(const Simplex& simplex);

/// What a search for a separating direction ended with.
struct GjkResult {
  bool free = false;  ///< a direction with at most the tolerance was found: a proof
  bool cores_meet =
      false;  ///< the cores (without balls) touch or overlap as far as rounding can tell
  Simplex simplex;
};

/// Gilbert, Johnson, Keerthi 1988 on the difference set of the cores, every support point being
/// tried as a certificate. For cores that are apart the direction converges to that of the closest
/// points, which is the one of least overlap.
GjkResult gjk(const SweptPair& pair);

}  // namespace rubicon::collision
