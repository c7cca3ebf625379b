#pragma once

#include <memory>
#include <vector>

#include "src/motion/geometry/shape.hpp"
#include "tests/proof/path.hpp"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace rubicon::collision::proof {

/// A shape of FCL; may be used by several threads once made.
using FclGeometry = std::shared_ptr<const fcl::CollisionGeometry<double>>;

FclGeometry fcl_box(const Vec3& half);
FclGeometry fcl_sphere(double radius);
FclGeometry fcl_capsule(double radius, double half_length);
FclGeometry fcl_cylinder(double radius, double half_length);
/// A prism over a convex polygon.
FclGeometry fcl_prism(const std::vector<Eigen::Vector2d>& polygon, double z0, double z1);
/// The triangles, in a tree of OBBRSS.
FclGeometry fcl_mesh(const geometry::TriangleMesh& mesh);

/// fcl::collide, yes or no, with libccd.
bool fcl_collide(const FclGeometry& a, const Pose& X_WA, const FclGeometry& b, const Pose& X_WB);

/// fcl::continuousCollide as it comes: ten poses. Its kind of motion, by default one that drops the
/// rotation, is set to the screw between the ends where the path turns.
bool fcl_continuous(const FclGeometry& a, const Path& path, const FclGeometry& b, const Pose& X_WB);

}  // namespace rubicon::collision::proof
