#pragma once

#include <memory>

#include "src/motion/collision/swept_query.hpp"

namespace rubicon::collision::test {

/// One solid seen through fcl::collide (GST_LIBCCD, yes or no at one pose), larger by `grow` metres
/// on every side, or smaller where negative.
class FclSolid {
 public:
  enum class Kind { kBox, kSphere, kCapsule, kCylinder };

  Kind kind = Kind::kBox;
  math::Vec3 half =
      math::Vec3::Constant(0.5);  ///< box: half extents; round: radius, -, half the length

  geometry::Shape shape() const;
  /// Greatest distance of a point from the origin of the shape.
  double reach() const;
};

bool fcl_collide(const FclSolid& a, const Pose& X_WA, double grow_a, const FclSolid& b,
                 const Pose& X_WB);

}  // namespace rubicon::collision::test
