#pragma once

#include <algorithm>
#include <limits>

#include "src/motion/collision/tree/wide_node.hpp"

namespace rubicon::collision {

/// Meets nothing, and joined with another box is that box.
inline constexpr FloatBox kEmptyBox = {
    {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
     std::numeric_limits<float>::infinity()},
    {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
     -std::numeric_limits<float>::infinity()}};

inline void join(FloatBox& box, const FloatBox& other) {
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = std::min(box.lower[axis], other.lower[axis]);
    box.upper[axis] = std::max(box.upper[axis], other.upper[axis]);
  }
}

inline FloatBox joined(FloatBox box, const FloatBox& other) {
  join(box, other);
  return box;
}

/// Half of the surface; 0 for an empty box. In doubles: infinite boxes give infinity, not NaN.
inline double area(const FloatBox& box) {
  const double x = static_cast<double>(box.upper[0]) - box.lower[0];
  const double y = static_cast<double>(box.upper[1]) - box.lower[1];
  const double z = static_cast<double>(box.upper[2]) - box.lower[2];
  return x >= 0 && y >= 0 && z >= 0 ? x * y + y * z + z * x : 0;
}

}  // namespace rubicon::collision
