#pragma once

#include "tests/proof/path.hpp"
#include "tests/proof/polytope.hpp"
#include "tests/proof/solid.hpp"

namespace rubicon::collision::proof {

/// Two polytopes on their ways: exact axes of the swept solid if neither turns, else branch and
/// bound over the depth at single poses.
Truth polytopes_truth(const Polytope& a, const Path& path_a, const Polytope& b, const Path& path_b,
                      double contact_tolerance);

/// A convex solid on its way past another through fcl::collide alone. Free: over pieces of the way
/// `a`, grown by half the motion of the piece, meets nothing, perhaps after a shift by less than
/// the tolerance (for a translation one shift for the whole way). Hit: at some pose every shift by
/// a little more than the tolerance still meets `b`. All else is near the boundary.
Truth fcl_truth(const Solid& a, const Path& path, const Solid& b, const Pose& X_WB,
                double contact_tolerance);

}  // namespace rubicon::collision::proof
