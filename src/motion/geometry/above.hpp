#pragma once

#include "src/motion/geometry/shape.hpp"

namespace rubicon::geometry {

/// m: how far above people no load may hang; more than any crane is high.
inline constexpr double kAirOverPeople = 1000;

/// Whether what stands there is turned about the vertical only, but for rounding.
bool stands_upright(const math::Pose& X_W);

/// The shape and what lies above it, up to the height `top` (m, in the frame in which the shape is
/// placed). Exact for boxes, prisms and cylinders that stand upright, for spheres and for upright
/// capsules (which end in half a ball at `top`); of anything else the upright box around it. The
/// shape itself where it reaches `top`.
Shape with_what_is_above(const Shape& shape, double top);

/// m: height of the upper end of a shape, in the frame in which it is placed.
double highest_point(const Shape& shape);

}  // namespace rubicon::geometry
