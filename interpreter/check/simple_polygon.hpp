#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::interpreter {

/// Most corners of a polygon in a text; the test for crossings is quadratic in the worst case.
inline constexpr std::size_t kMaxPolygonCorners = 4096;

/// What keeps `polygon` (m) from being simple, for a message: equal neighbouring corners, an edge
/// that folds back, edges that meet, no area. Corners count from 1. Nothing if it is simple.
std::optional<std::string> polygon_fault(const std::vector<Eigen::Vector2d>& polygon);

}  // namespace rubicon::interpreter
