#include "src/motion/geometry/extent.hpp"

#include <variant>
#include <vector>

namespace rubicon::geometry {

namespace {

using Extent = Eigen::AlignedBox3d;

Extent box_around(const std::vector<Vec3>& points, const Pose& X) {
  Extent box;
  for (const Vec3& point : points) box.extend(X * point);
  return box;
}

Extent box_around_ball(const Vec3& centre, double radius) {
  const Vec3 half = Vec3::Constant(radius);
  return {centre - half, centre + half};
}

Extent extent_of(const Box& box, const Pose& X) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(Extent(box.lower, box.upper).corner(static_cast<Extent::CornerType>(i)));
  }
  return box_around(corners, X);
}

/// Of a disc about its axis: half its width along each axis is r sqrt(1 - a^2).
Extent extent_of(const Cylinder& cylinder, const Pose& X) {
  const Vec3 axis = X.linear().col(2);
  const Vec3 half =
      cylinder.radius * (Vec3::Ones() - axis.cwiseProduct(axis)).cwiseMax(Vec3::Zero()).cwiseSqrt();
  Extent box;
  for (const double z : {cylinder.z0, cylinder.z1}) {
    const Vec3 centre = X * Vec3(0, 0, z);
    box.extend(Extent(centre - half, centre + half));
  }
  return box;
}

Extent extent_of(const Sphere& sphere, const Pose& X) {
  return box_around_ball(X * sphere.centre, sphere.radius);
}

Extent extent_of(const Capsule& capsule, const Pose& X) {
  Extent box = box_around_ball(X * capsule.a, capsule.radius);
  return box.extend(box_around_ball(X * capsule.b, capsule.radius));
}

Extent extent_of(const Prism& prism, const Pose& X) {
  std::vector<Vec3> corners;
  for (const Eigen::Vector2d& corner : prism.polygon) {
    for (const double z : {prism.z0, prism.z1}) corners.emplace_back(corner.x(), corner.y(), z);
  }
  return box_around(corners, X);
}

Extent extent_of(const Mesh& mesh, const Pose& X) { return box_around(mesh.mesh->vertices, X); }

}  // namespace

Eigen::AlignedBox3d extent_of(const Shape& shape) {
  return std::visit([&](const auto& solid) { return extent_of(solid, shape.X_BS); }, shape.solid);
}

}  // namespace rubicon::geometry
