#pragma once

#include "src/results/verify/input/convex.hpp"
#include "src/results/verify/input/mechanism.hpp"

namespace rubicon::verify {

/// How deep two convex solids are in each other: the least distance by which one would have to be
/// pushed to have them apart. What is asked is not the number but which side of it is the limit.
struct DepthQuery {
  double limit = 0;  ///< m: as deep as this is no fault
  double alarm = 0;  ///< m, less than limit: deeper than this is a fault
  Reach reach;       ///< of their points against each other, in the frame of `b`
};

enum class Nearness {
  free,   ///< within the reach they are nowhere deeper than the limit
  deep,   ///< where they are now they are deeper than the alarm
  unsure  ///< neither: look at a smaller reach
};

struct DepthResult {
  Nearness nearness = Nearness::unsure;
  double depth = 0;  ///< m, of what is deep
};

/// `a` stands at X_BA in the frame of `b`. Free is proved by one direction along which the depth
/// and the reach together are within the limit; deep by the inside of the difference of the two.
DepthResult depth_test(const Convex& a, const Pose& X_BA, const Convex& b, const DepthQuery& query);

}  // namespace rubicon::verify
