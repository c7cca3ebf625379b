#pragma once

#include <optional>

#include "src/motion/collision/sweep/motion_tree.hpp"

namespace rubicon::collision {

/// Whether piece `a` of body A and piece `b` of body B get deeper than `tolerance` (m) into each
/// other somewhere on the slice. False is always proved. Each piece is in the (centred) frame of
/// its own body.
/// `intervals` counts what all pairs of the two bodies have looked at; beyond
/// `kMaxIntervalsOfBodies` the answer is yes.
bool pair_blocked(const Convex& a, const Convex& b, MotionTree& tree, double tolerance,
                  int& intervals);

/// Where on the slice (share of the whole step) two pieces first get deeper than `tolerance`: the
/// slice is proved free of them up to there, and contact begins within `kContactResolution` of the
/// step after it. Nothing where they stay free, or free up to `before`, from where on it does not
/// matter.
std::optional<double> first_contact(const Convex& a, const Convex& b, MotionTree& tree,
                                    double tolerance, double before);

}  // namespace rubicon::collision
