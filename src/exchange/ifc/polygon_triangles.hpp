#pragma once

#include <array>
#include <optional>
#include <vector>

#include "src/exchange/ifc/work_budget.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::ifc {

/// A closed line of corners, as indices.
using Loop = std::vector<int>;

/// The direction a loop in space turns about, as long as twice the area inside (Newell's method).
math::Vec3 loop_normal(const std::vector<math::Vec3>& points, const Loop& loop);

/// Splits an area into triangles: `loops` run counterclockwise about it seen against `normal`,
/// those around holes clockwise, in any order. Every corner is kept, also those on straight lines,
/// so that neighbouring faces fit. Nothing if the loops cross themselves or each other, or hold no
/// area. Corners may touch other loops.
///
/// Holes are joined to the outline by bridges (Eberly, "Triangulation by Ear Clipping"), then ears
/// are cut off. What lies left and right is decided with whole numbers, without rounding.
std::optional<std::vector<std::array<int, 3>>> triangulate(const std::vector<math::Vec3>& points,
                                                           const std::vector<Loop>& loops,
                                                           const math::Vec3& normal,
                                                           WorkBudget& budget, double thin = 0);

/// Whether two sides of loops cross, seen along `normal`; also where that cannot be told within the
/// budget. Touching is not crossing.
bool lines_cross(const std::vector<math::Vec3>& points, const std::vector<Loop>& loops,
                 const math::Vec3& normal, WorkBudget& budget);

}  // namespace rubicon::ifc
