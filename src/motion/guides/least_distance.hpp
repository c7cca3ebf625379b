#pragma once

#include <span>

#include "src/motion/guides/space.hpp"

namespace rubicon::guides {

/// Never more than the distance of two points, and soon found: of a vehicle that steers by the
/// straight line between its places, of anything else the distance itself.
double least_distance(const Space& space, std::span<const double> a, std::span<const double> b);

}  // namespace rubicon::guides
