#pragma once

#include <array>
#include <vector>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::mesh_io {

/// Corners nearer than this become one (metres). Exporters round corners of neighbouring triangles
/// apart; anything a site model means is a thousand times larger.
inline constexpr double kWeldTolerance = 1e-6;

/// Formats and assimp hold single precision, so the same corner reached over two nodes differs by
/// about one unit in its last place: the tolerance grows with the largest coordinate by this
/// factor.
inline constexpr double kWeldPerMetre = 1.2e-7;

/// The grown tolerance stays below a tenth of the usual contact tolerance of 1 mm, so that repair
/// never closes a joint that a step must respect.
inline constexpr double kLargestWeldTolerance = 1e-4;

/// What `repair` changed.
struct RepairReport {
  int welded_vertices = 0;       ///< corners that became one with an earlier one
  int degenerate_triangles = 0;  ///< left out: two corners are one, or they lie on a line
  int duplicate_triangles = 0;   ///< left out: one of the same corners came before
  int turned_triangles = 0;     ///< orientation reversed so that neighbours agree and face outwards
  int thin_triangles_kept = 0;  ///< corners on a line, but the closed surface needs them
};

struct RepairedMesh {
  geometry::TriangleMesh mesh;  ///< no triangles when nothing of any size was there
  RepairReport report;
};

/// Welds equal corners, leaves out degenerate and duplicate triangles, makes orientations agree
/// where every edge has exactly two triangles, turns a closed surface outwards, and says whether it
/// is closed. Vertices must be finite and below 1e9 m, indices in range. The order of triangles,
/// and of vertices by first use, is kept.
///
/// Closed means: every edge is used equally often in both directions (so the winding number of a
/// point is defined; two bodies that share an edge stay closed) and the volume is not zero.
RepairedMesh repair(const std::vector<geometry::Vec3>& vertices,
                    const std::vector<std::array<int, 3>>& triangles);

}  // namespace rubicon::mesh_io
