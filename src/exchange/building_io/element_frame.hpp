#pragma once

#include "src/exchange/building_io/element.hpp"

namespace rubicon::building_io {

/// Places are given to 0.01 mm: finer than any model is drawn, and short to read.
inline constexpr double kPlacesPerMetre = 1e5;

/// A number on that grid, never -0.
double on_grid(double metres);

/// The frame of a mesh (z up, metres): the smallest upright box about it, by the edges of the hull
/// of its outline (Freeman and Shapira, Determining the minimum-area encasing rectangle, 1975). Of
/// boxes equally small the one along the longest edge. Turned by whole degrees where it is within
/// 0.01 degrees of one.
ElementFrame frame_of(const geometry::TriangleMesh& mesh);

/// The mesh in that frame.
geometry::TriangleMesh in_frame(const geometry::TriangleMesh& mesh, const ElementFrame& frame);

}  // namespace rubicon::building_io
