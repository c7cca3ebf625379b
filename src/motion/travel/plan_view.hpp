#pragma once

#include <vector>

#include "src/motion/geometry/shape.hpp"
#include "src/motion/travel/exact.hpp"

namespace rubicon::travel {

/// From a least to a greatest value: a slab of heights, m in the frame that is looked at from
/// above.
struct Heights {
  double low = 0;
  double high = 0;
};

/// The part of a shape between two heights, seen from above: simple polygons (m, x east and y
/// north) that it lies in. Exact for boxes and for convex prisms however they stand, and for
/// prisms that stand upright; a round outline is the polygon of 32 sides about it (0.49 per cent of
/// the radius larger at most). Of anything else what is convex about it: never less than the shape.
/// Nothing where the shape does not reach into the slab; touching it from outside is none.
/// `X_WS`: the frame of the shape's body in the one that is looked at.
std::vector<std::vector<Vec2>> plan_view(const geometry::Shape& shape, const math::Pose& X_WB,
                                         const Heights& heights);

/// The heights that shapes take up, in the same frame as above; low > high where there are none.
Heights heights_of(const std::vector<geometry::Shape>& shapes, const math::Pose& X_WB);

/// The radius of the smallest disc about a vertical axis through a point that holds the shapes (m).
double reach_about(const Vec2& axis, const std::vector<geometry::Shape>& shapes,
                   const math::Pose& X_WB);

/// How far shapes reach along a horizontal unit vector, as places on it (m): low > high where there
/// are none.
Heights extent_along(const Vec2& direction, const std::vector<geometry::Shape>& shapes,
                     const math::Pose& X_WB);

}  // namespace rubicon::travel
