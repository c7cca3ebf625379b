#pragma once

#include "src/motion/collision/base/placement.hpp"

namespace rubicon::collision {

/// A box with its own axes: the points centre + R v with |v_i| <= half_i (m).
struct OrientedBox {
  Mat3 R = Mat3::Identity();
  Vec3 centre = Vec3::Zero();
  Vec3 half = Vec3::Zero();
};

inline OrientedBox placed(const OrientedBox& box, const Placement& X) {
  return {X.R * box.R, X * box.centre, box.half};
}

}  // namespace rubicon::collision
