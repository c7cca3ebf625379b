#pragma once

#include <vector>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::mesh_io {

/// A point may lie this far (m) outside a face of a hull: what the collision module allows a
/// convex part of a mesh as well, a ten-thousandth of the usual contact tolerance.
inline constexpr double kHullSlack = 1e-7;

/// Faces with a smaller altitude (m) are not asked: their plane is not known well enough, and
/// between their neighbours no more than this can stick out.
inline constexpr double kHullSliver = 1e-6;

enum class HullCheck {
  kContains,     ///< every point is inside or within kHullSlack
  kSticksOut,    ///< some point is not
  kTooMuchWork,  ///< not decided: too many faces and points for a bounded time
};

/// Whether a closed, outward mesh has all points on the inner side of every face. With a tree of
/// boxes over the points: mostly (faces x log points) steps.
HullCheck hull_contains(const geometry::TriangleMesh& hull,
                        const std::vector<geometry::Vec3>& points);

}  // namespace rubicon::mesh_io
