#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "src/motion/geometry/motion.hpp"
#include "src/motion/geometry/shape.hpp"

namespace rubicon::bench {

using math::Pose;
using math::Vec3;

/// A box or a mesh that stands in the scene.
struct Standing {
  int solid = 0;  ///< index into SweptScene::solids
  Pose X_WB = Pose::Identity();
};

/// A load, the steps it is asked to make, and what stands around: both engines are built from it.
/// Solids are boxes about their origin and meshes.
struct SweptScene {
  std::vector<geometry::Solid> solids;
  std::vector<Standing> standing;
  geometry::Solid load;
  std::vector<geometry::ScrewMotion> steps;
};

/// Corners of a box, vertices of a mesh, in the frame of the solid.
std::vector<Vec3> corners_of(const geometry::Solid& solid);

/// The exact bounds (m, world) of points that make a step: ends of the way, and where an arc turns
/// back along a world axis.
Eigen::AlignedBox3d swept_bounds(const std::vector<Vec3>& points,
                                 const geometry::ScrewMotion& step);

/// Length (m) of the longest way a point goes.
double longest_way(const std::vector<Vec3>& points, const geometry::ScrewMotion& step);

/// A box of these half extents (m) about its origin.
geometry::Box centred_box(const Vec3& half);

}  // namespace rubicon::bench
