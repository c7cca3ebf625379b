#include "src/motion/collision/query/overlap_depth.hpp"

#include <algorithm>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/pair/body_depth.hpp"
#include "src/motion/collision/pair/containment.hpp"
#include "src/motion/collision/sweep/body.hpp"
#include "src/motion/collision/sweep/relative_motion.hpp"

namespace rubicon::collision {

double overlap_depth(const Body& a, const Pose& X_WA, const Body& b, const Pose& X_WB) {
  const MovingBody still_a{&a, geometry::stationary(X_WA)};
  const MovingBody still_b{&b, geometry::stationary(X_WB)};
  const double depth = body_depth(still_a, still_b, 0);
  // Of a point inside a closed mesh it is only asked how deep it is.
  if (!a.has_closed_soup() && !b.has_closed_soup()) return depth;
  const RelativeMotion motion(still_a.motion, a.extent(), still_b.motion, b.extent());
  const Placement a_in_b = motion.slice(0, 0).a_in_b.start;
  double known = std::max(depth, kRoundingDepth);
  if (!contained(a, b, a_in_b, known)) return depth;
  double above = std::min(a.bounds().half().minCoeff(), b.bounds().half().minCoeff());
  while (above - known > kDepthResolution) {
    const double middle = 0.5 * (known + above);
    (contained(a, b, a_in_b, middle) ? known : above) = middle;
  }
  return known;
}

}  // namespace rubicon::collision
