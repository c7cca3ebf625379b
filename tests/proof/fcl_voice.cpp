#include "tests/proof/fcl_voice.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <stdexcept>

namespace rubicon::collision::proof {

FclGeometry fcl_box(const Vec3& half) { return std::make_shared<fcl::Boxd>(2 * half); }
FclGeometry fcl_sphere(double radius) { return std::make_shared<fcl::Sphered>(radius); }
FclGeometry fcl_capsule(double radius, double half_length) {
  return std::make_shared<fcl::Capsuled>(radius, 2 * half_length);
}
FclGeometry fcl_cylinder(double radius, double half_length) {
  return std::make_shared<fcl::Cylinderd>(radius, 2 * half_length);
}

FclGeometry fcl_prism(const std::vector<Eigen::Vector2d>& polygon, double z0, double z1) {
  const int count = static_cast<int>(polygon.size());
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const double z : {z0, z1}) {
    for (const Eigen::Vector2d& corner : polygon) vertices->emplace_back(corner.x(), corner.y(), z);
  }
  // Each face: the number of its corners, then the corners, counter-clockwise from outside.
  auto faces = std::make_shared<std::vector<int>>();
  faces->push_back(count);
  for (int i = count - 1; i >= 0; --i) faces->push_back(i);
  faces->push_back(count);
  for (int i = 0; i < count; ++i) faces->push_back(count + i);
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    faces->insert(faces->end(), {4, i, next, count + next, count + i});
  }
  return std::make_shared<fcl::Convexd>(vertices, count + 2, faces);
}

FclGeometry fcl_mesh(const geometry::TriangleMesh& mesh) {
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  std::vector<fcl::Vector3d> vertices(mesh.vertices.begin(), mesh.vertices.end());
  std::vector<fcl::Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(a, b, c);
  if (model->beginModel() != fcl::BVH_OK ||
      model->addSubModel(vertices, triangles) != fcl::BVH_OK || model->endModel() != fcl::BVH_OK) {
    throw std::runtime_error("FCL does not take a mesh");
  }
  model->computeLocalAABB();
  return model;
}

bool fcl_collide(const FclGeometry& a, const Pose& X_WA, const FclGeometry& b, const Pose& X_WB) {
  fcl::CollisionRequestd request;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::CollisionResultd result;
  return fcl::collide(a.get(), X_WA, b.get(), X_WB, request, result) > 0;
}

bool fcl_continuous(const FclGeometry& a, const Path& path, const FclGeometry& b,
                    const Pose& X_WB) {
  fcl::ContinuousCollisionRequestd request;
  if (!path.translates()) request.ccd_motion_type = fcl::CCDM_SCREW;
  fcl::ContinuousCollisionResultd result;
  fcl::continuousCollide(a.get(), path.pose(0), path.pose(1), b.get(), X_WB, X_WB, request, result);
  return result.is_collide;
}

}  // namespace rubicon::collision::proof
