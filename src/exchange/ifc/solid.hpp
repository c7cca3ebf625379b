#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "src/exchange/ifc/polygon_triangles.hpp"
#include "src/exchange/ifc/work_budget.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::ifc {

/// A surface of triangles, counterclockwise seen from outside; a body where it is closed. Metres.
struct Solid {
  std::vector<math::Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// From corner to corner, as indices.
using Edge = std::pair<int, int>;

/// A side of a plane: n * p <= w is inside. n has length 1.
struct HalfSpace {
  math::Vec3 n = math::Vec3::UnitZ();
  double w = 0;
};

/// Nearer to a plane than this (metres) a corner lies on it: far below the tolerance of contact,
/// and above what programs round coordinates to.
inline constexpr double kOnPlane = 1e-5;

/// Whether every edge is used equally often in both directions. Corners count as they are numbered.
bool is_closed(const Solid& solid);

/// Volume of a closed surface, above zero where it looks outwards.
double volume_of(const Solid& solid);

/// Corners at exactly the same place become one; triangles that lose a corner go.
Solid welded(const Solid& solid);

/// Strikes out pairs of edges that run both ways; sorted.
std::vector<Edge> net(std::vector<Edge> edges);

/// Without corners that nothing uses.
Solid compact(const Solid& solid);

/// The directed edges that remain when those that run both ways are struck out, in loops: how the
/// area that is missing to a closed surface, or is left of one, is bordered. At a corner where
/// several meet the one most to the left is followed, seen against `normal`. Nothing if they do
/// not meet end to end.
std::optional<std::vector<Loop>> border_loops(const std::vector<math::Vec3>& points,
                                              std::vector<Edge> edges, const math::Vec3& normal);

}  // namespace rubicon::ifc
