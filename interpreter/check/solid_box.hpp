#pragma once

#include <Eigen/Geometry>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::interpreter {

/// The box around a solid, in the frame of its shape (m).
Eigen::AlignedBox3d box_around(const geometry::Solid& solid);

}  // namespace rubicon::interpreter
