#include "src/motion/collision/pair/body_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/convex/separation.hpp"
#include "src/motion/collision/pair/part_pairs.hpp"

namespace rubicon::collision {

namespace {

/// The depth of a standing pair if it is more than `known` (m), else `known`: the greatest
/// tolerance with which it is not free, by halving.
double pair_depth(SweptPair& pair, double known) {
  const auto deeper_than = [&](double depth) {
    pair.tolerance = std::max(depth, kRoundingDepth);
    return !separated(pair);
  };
  if (!deeper_than(known)) return known;
  double deep = known;
  double shallow = std::max(2 * known, 1e-3);
  while (deeper_than(shallow) && std::isfinite(shallow)) {
    deep = shallow;
    shallow *= 2;
  }
  while (shallow - deep > kDepthResolution) {
    const double middle = deep + (shallow - deep) / 2;
    if (middle <= deep || middle >= shallow) break;
    (deeper_than(middle) ? deep : shallow) = middle;
  }
  return deep;
}

}  // namespace

double body_depth(const MovingBody& a, const MovingBody& b, double fraction) {
  if (!(fraction >= 0 && fraction <= 1)) {
    throw std::invalid_argument(fmt::format("a share of a step is 0 to 1, not {}", fraction));
  }
  const RelativeMotion motion(a.motion, a.body->extent(), b.motion, b.body->extent());
  const Slice pose = motion.slice(fraction, fraction);
  const PartPairs pairs(*a.body, *b.body, motion);
  double deepest = 0;
  const auto look = [&](const Convex& piece_a, const Convex& piece_b) {
    SweptPair pair;
    pair.moving = piece_a;
    pair.fixed = piece_b;
    pair.stand_at(pose.a_in_b.start);
    deepest = pair_depth(pair, deepest);
    return false;
  };
  pairs.any(pose, 0, look);
  return deepest;
}

}  // namespace rubicon::collision
