#pragma once

#include "src/collision/motion_tree.hpp"

namespace rubicon::collision {

/// Whether piece `a` of body A and piece `b` of body B get deeper than `tolerance` (m) into each
/// other somewhere on the slice. False is always proved. Each piece is in the (centred) frame of
/// its own body.
bool pair_blocked(const Convex& a, const Convex& b, MotionTree& tree, double tolerance);

/// The contact tolerance of a pair of pieces by their widths: the given one, less for thin things
/// (see `kThinShare`).
double pair_tolerance(double width_a, double width_b, double contact_tolerance);

}  // namespace rubicon::collision
