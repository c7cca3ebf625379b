#include "src/motion/geometry/above.hpp"

#include <algorithm>

#include "src/motion/geometry/extent.hpp"

namespace rubicon::geometry {

namespace {

bool is_upright(const Pose& X) { return X.linear().col(2) == Vec3::UnitZ(); }

Shape upright_box(Eigen::AlignedBox3d box, double top) {
  box.max().z() = std::max(box.max().z(), top);
  return {Box{box.min(), box.max()}, Pose::Identity()};
}

}  // namespace

double highest_point(const Shape& shape) { return extent_of(shape).max().z(); }

bool stands_upright(const math::Pose& X_W) {
  constexpr double kRounding = 1e-9;
  return X_W.linear()(2, 2) > 1 - kRounding;
}

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
