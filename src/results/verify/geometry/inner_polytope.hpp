#pragma once

#include "src/results/verify/geometry/depth.hpp"

namespace rubicon::verify {

/// depth_test for any two convex solids. The points p_A - p_B make a convex solid; the depth is the
/// distance of the origin from its outside. A polytope inside of it is expanded where it is nearest
/// to the origin (van den Bergen, Proximity queries and penetration depth computation on 3D game
/// objects, 2001, from a polytope that need not hold the origin yet): every direction that is tried
/// may prove the two free, and the polytope proves them deep once it holds a ball of the alarm.
DepthResult test_by_inner_polytope(const Convex& a, const Pose& X_BA, const Convex& b,
                                   const DepthQuery& query);

}  // namespace rubicon::verify
