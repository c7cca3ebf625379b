#pragma once

#include <functional>

#include "src/motion/math/pose.hpp"

namespace rubicon::collision::test {

using math::Mat3;
using math::Pose;
using math::Vec3;

/// A box by its centre and half extents: nothing here shares code with the engine.
struct OracleBox {
  Pose X_WC = Pose::Identity();  ///< of the box's centre
  Vec3 half = Vec3::Constant(0.5);
};

/// Depth of two boxes at fixed poses: the least overlap over the 15 axes of Gottschalk; negative
/// when apart.
double box_depth(const OracleBox& a, const OracleBox& b);

/// Depth of the volume that `a` sweeps along d against `b`: the least overlap over 21 axes; exact.
double swept_box_depth(const OracleBox& a, const Vec3& d, const OracleBox& b);

enum class Truth { kFree, kHit, kNearBoundary };

/// How many cases had which answer.
struct Count {
  int free = 0;
  int hit = 0;
};

/// Whether the depth over s in [0, 1] stays below `tolerance` - `band` or exceeds `tolerance` +
/// `band` somewhere, by branch and bound; `speed` bounds how far any point of one box moves against
/// the other per unit of s.
Truth classify(const std::function<double(double)>& depth, double speed, double tolerance,
               double band);

}  // namespace rubicon::collision::test
