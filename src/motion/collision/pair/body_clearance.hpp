#pragma once

#include "src/motion/collision/sweep/body.hpp"

namespace rubicon::collision {

/// The nearest miss found so far among several pairs of bodies.
struct NearestMiss {
  double range = 0;       ///< m, what is farther apart does not count
  double resolution = 0;  ///< m, how near the two bounds should come to each other
  double certified = 0;   ///< m, least lower bound of all that was looked at; starts as infinity
  double found = 0;       ///< m, least distance between two points; starts as infinity
  double fraction = 0;    ///< of the step, for `found`
  Vec3 on_a_W = Vec3::Zero();
  Vec3 on_b_W = Vec3::Zero();

  /// What is farther apart than this cannot change the result.
  double reach() const { return found < range ? found : range; }
};

/// Takes two bodies into account while `a` and `b` move; whether `nearest.found` became less.
bool add_clearance(const Body& a, const Motion& motion_a, const Body& b, const Motion& motion_b,
                   double contact_tolerance, NearestMiss& nearest);

}  // namespace rubicon::collision
