#include "src/motion/geometry/above.hpp"

#include <Eigen/Geometry>
#include <algorithm>

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

Extent extent_of(const Shape& shape) {
  return std::visit([&](const auto& solid) { return extent_of(solid, shape.X_BS); }, shape.solid);
}

bool is_upright(const Pose& X) { return X.linear().col(2) == Vec3::UnitZ(); }

Shape upright_box(Extent box, double top) {
  box.max().z() = std::max(box.max().z(), top);
  return {Box{box.min(), box.max()}, Pose::Identity()};
}

}  // namespace

double highest_point(const Shape& shape) { return extent_of(shape).max().z(); }

Shape with_what_is_above(const Shape& shape, double top) {
  if (highest_point(shape) >= top) return shape;
  Shape raised = shape;
  const bool upright = is_upright(shape.X_BS);
  const double top_S = top - shape.X_BS.translation().z();
  if (auto* box = std::get_if<Box>(&raised.solid); box != nullptr && upright) {
    box->upper.z() = top_S;
    return raised;
  }
  if (auto* cylinder = std::get_if<Cylinder>(&raised.solid); cylinder != nullptr && upright) {
    cylinder->z1 = top_S;
    return raised;
  }
  if (auto* prism = std::get_if<Prism>(&raised.solid); prism != nullptr && upright) {
    prism->z1 = top_S;
    return raised;
  }
  if (const auto* sphere = std::get_if<Sphere>(&shape.solid)) {
    const Vec3 centre = shape.X_BS * sphere->centre;
    return {Capsule{centre, Vec3(centre.x(), centre.y(), top), sphere->radius}, Pose::Identity()};
  }
  if (const auto* capsule = std::get_if<Capsule>(&shape.solid)) {
    const Vec3 a = shape.X_BS * capsule->a;
    const Vec3 b = shape.X_BS * capsule->b;
    if (a.head<2>() == b.head<2>()) {
      const Vec3& lower = a.z() < b.z() ? a : b;
      return {Capsule{lower, Vec3(lower.x(), lower.y(), top), capsule->radius}, Pose::Identity()};
    }
  }
  return upright_box(extent_of(shape), top);
}

}  // namespace rubicon::geometry
