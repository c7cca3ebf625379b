#pragma once

#include "tests/unit/collision/box_oracle.hpp"

namespace rubicon::collision::test {

/// Distance of two boxes, 0 where they overlap: the least over corners and boxes, edges and edges;
/// exact.
double box_distance(const OracleBox& a, const OracleBox& b);

/// Distance of a point from a box, 0 inside.
double point_box_distance(const Vec3& point, const OracleBox& box);

/// Distance of the segments a0-a1 and b0-b1.
double segment_distance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

}  // namespace rubicon::collision::test
