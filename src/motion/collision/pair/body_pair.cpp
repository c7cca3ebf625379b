#include "src/motion/collision/pair/body_pair.hpp"

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/pair/containment.hpp"
#include "src/motion/collision/pair/convex_narrow_phase.hpp"
#include "src/motion/collision/pair/part_pairs.hpp"

namespace rubicon::collision {

bool bodies_blocked(const Body& a, const Motion& motion_a, const Body& b, const Motion& motion_b,
                    double contact_tolerance) {
  const RelativeMotion motion(motion_a, a.extent(), motion_b, b.extent());
  const int count = useful_slices(motion, a.extent().radius + b.extent().radius);
  const PartPairs pairs(a, b, motion);
  int intervals = 0;
  for (int i = 0; i < count; ++i) {
    MotionTree tree(motion, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    // From outside a closed mesh one must cross its surface, so the ends of the step are enough.
    if (i == 0 && contained(a, b, tree.slice().a_in_b.start, contact_tolerance)) return true;
    const auto blocked = [&](const Convex& piece_a, const Convex& piece_b) {
      return pair_blocked(piece_a, piece_b, tree,
                          pair_tolerance(piece_a.width, piece_b.width, contact_tolerance),
                          intervals);
    };
    if (pairs.any(tree.slice(), 0, blocked)) return true;
    if (i + 1 == count && motion.kind() != RelativeMotion::Kind::kStill &&
        contained(a, b, tree.slice().a_in_b.end, contact_tolerance)) {
      return true;
    }
  }
  return false;
}

}  // namespace rubicon::collision
