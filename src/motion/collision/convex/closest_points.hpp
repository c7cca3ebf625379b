#pragma once

#include "src/motion/collision/convex/swept_pair.hpp"

namespace rubicon::collision {

/// How near a swept solid comes to a standing one, in the frame of the standing one. Where they
/// overlap, both points are the same one of both solids, and the distances are 0.
struct ClosestPoints {
  Vec3 moving = Vec3::Zero();
  Vec3 fixed = Vec3::Zero();
  /// m, certified by a direction: over the whole interval the solids stay so far apart along it.
  double lower_bound = 0;
  /// m, between the two points. The moving one belongs to the solid at the start, at the end, or
  /// to a mixture of both; for a standing pair it is a point of the solid.
  double upper_bound = 0;
};

/// Gilbert, Johnson, Keerthi 1988 with the points kept. To about 1e-9 m for polytopes, and a little
/// less well for round shapes; the lower bound always holds.
ClosestPoints closest_points(const SweptPair& pair);

}  // namespace rubicon::collision
