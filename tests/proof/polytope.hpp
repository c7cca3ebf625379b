#pragma once

#include <limits>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::collision::proof {

using math::Mat3;
using math::Pose;
using math::Vec3;

/// A convex polytope by its corners, face normals and edge directions (unit vectors up to sign).
/// Shares no code with the engine. A triangle is a flat one.
struct Polytope {
  std::vector<Vec3> vertices;
  std::vector<Vec3> normals;
  std::vector<Vec3> edges;
  double width = 0;  ///< m, of the thing it belongs to, at its thinnest
};

Polytope box_polytope(const Vec3& half);
/// A prism over a convex polygon.
Polytope prism_polytope(const std::vector<Eigen::Vector2d>& polygon, double z0, double z1);
Polytope triangle_polytope(const Vec3& a, const Vec3& b, const Vec3& c);

/// Greatest distance of a corner from the origin of the frame (m).
double reach_of(const Polytope& polytope);

/// `polytope` seen from the frame in which it stands at X; `result` is overwritten, its memory
/// used again.
void place(const Polytope& polytope, const Pose& X, Polytope& result);
Polytope placed(const Polytope& polytope, const Pose& X);

/// Depth of the volume that `a` sweeps along d against `b`, both in one frame: the least overlap
/// over the complete set of axes (face normals of both, edge x edge, d x edge), negative when
/// apart. Returns as soon as an overlap is not more than `enough`.
double swept_depth(const Polytope& a, const Vec3& d, const Polytope& b,
                   double enough = -std::numeric_limits<double>::infinity());
/// Depth at fixed poses.
double depth(const Polytope& a, const Polytope& b,
             double enough = -std::numeric_limits<double>::infinity());

/// The tolerance that docs/collision.md grants a pair of this thickness (m).
double pair_tolerance(double contact_tolerance, double width_a, double width_b);

}  // namespace rubicon::collision::proof
