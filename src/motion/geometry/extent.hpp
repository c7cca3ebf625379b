#pragma once

#include <Eigen/Geometry>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::geometry {

/// The upright box around a shape (m), in the frame in which it is placed; the tightest.
Eigen::AlignedBox3d extent_of(const Shape& shape);

}  // namespace rubicon::geometry
