#include "tests/unit/collision/fcl_oracle.hpp"

#include <fcl/narrowphase/collision.h>

namespace rubicon::collision::test {
namespace {

std::shared_ptr<fcl::CollisionGeometryd> geometry_of(const FclSolid& solid, double grow) {
  const math::Vec3 half = solid.half.array() + grow;
  switch (solid.kind) {
    case FclSolid::Kind::kBox:
      return std::make_shared<fcl::Boxd>(2 * half);
    case FclSolid::Kind::kSphere:
      return std::make_shared<fcl::Sphered>(half.x());
    case FclSolid::Kind::kCapsule:
      return std::make_shared<fcl::Capsuled>(half.x(), 2 * solid.half.z());
    case FclSolid::Kind::kCylinder:
      break;
  }
  return std::make_shared<fcl::Cylinderd>(half.x(), 2 * half.z());
}

}  // namespace

geometry::Shape FclSolid::shape() const {
  switch (kind) {
    case Kind::kBox:
      return {geometry::Box{-half, half}, Pose::Identity()};
    case Kind::kSphere:
      return {geometry::Sphere{math::Vec3::Zero(), half.x()}, Pose::Identity()};
    case Kind::kCapsule:
      return {geometry::Capsule{math::Vec3(0, 0, -half.z()), math::Vec3(0, 0, half.z()), half.x()},
              Pose::Identity()};
    case Kind::kCylinder:
      break;
  }
  return {geometry::Cylinder{half.x(), -half.z(), half.z()}, Pose::Identity()};
}

double FclSolid::reach() const {
  switch (kind) {
    case Kind::kBox:
      return half.norm();
    case Kind::kSphere:
      return half.x();
    case Kind::kCapsule:
      return half.x() + half.z();
    case Kind::kCylinder:
      break;
  }
  return math::Vec3(half.x(), 0, half.z()).norm();
}

bool fcl_collide(const FclSolid& a, const Pose& X_WA, double grow_a, const FclSolid& b,
                 const Pose& X_WB) {
  fcl::CollisionRequestd request;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::CollisionResultd result;
  // Constructed per call: FCL 0.7 shares nothing that could go stale this way.
  fcl::Transform3d X_a = X_WA;
  fcl::Transform3d X_b = X_WB;
  const auto geometry_a = geometry_of(a, grow_a);
  const auto geometry_b = geometry_of(b, 0);
  return fcl::collide(geometry_a.get(), X_a, geometry_b.get(), X_b, request, result) > 0;
}

}  // namespace rubicon::collision::test
