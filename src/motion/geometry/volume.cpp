#include "src/motion/geometry/volume.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace rubicon::geometry {

namespace {

using std::numbers::pi;

std::optional<Volume> volume_in_shape(const Box& box) {
  return Volume{(box.upper - box.lower).prod(), 0.5 * (box.lower + box.upper)};
}

std::optional<Volume> volume_in_shape(const Cylinder& cylinder) {
  return Volume{pi * cylinder.radius * cylinder.radius * (cylinder.z1 - cylinder.z0),
                Vec3(0, 0, 0.5 * (cylinder.z0 + cylinder.z1))};
}

double ball(double radius) { return 4.0 / 3.0 * pi * radius * radius * radius; }

std::optional<Volume> volume_in_shape(const Sphere& sphere) {
  return Volume{ball(sphere.radius), sphere.centre};
}

std::optional<Volume> volume_in_shape(const Capsule& capsule) {
  const double length = (capsule.b - capsule.a).norm();
  return Volume{pi * capsule.radius * capsule.radius * length + ball(capsule.radius),
                0.5 * (capsule.a + capsule.b)};
}

/// Relative to a corner, so that drawings far from the origin lose nothing.
std::optional<Volume> volume_in_shape(const Prism& prism) {
  const Eigen::Vector2d origin = prism.polygon.front();
  double twice_area = 0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < prism.polygon.size(); ++i) {
    const Eigen::Vector2d a = prism.polygon[i] - origin;
    const Eigen::Vector2d b = prism.polygon[(i + 1) % prism.polygon.size()] - origin;
    const double cross = a.x() * b.y() - a.y() * b.x();
    twice_area += cross;
    moment += cross * (a + b);
  }
  if (twice_area == 0) return std::nullopt;
  const Eigen::Vector2d middle = origin + moment / (3 * twice_area);
  return Volume{0.5 * std::abs(twice_area) * (prism.z1 - prism.z0),
                Vec3(middle.x(), middle.y(), 0.5 * (prism.z0 + prism.z1))};
}

std::optional<Volume> volume_in_shape(const Mesh& mesh) {
  if (!mesh.mesh || !mesh.mesh->closed || mesh.mesh->triangles.empty()) return std::nullopt;
  const std::vector<Vec3>& vertices = mesh.mesh->vertices;
  const auto corner = [&](int index) -> const Vec3& {
    return vertices[static_cast<std::size_t>(index)];
  };
  const Vec3& origin = corner(mesh.mesh->triangles.front()[0]);
  double six_volumes = 0;
  Vec3 moment = Vec3::Zero();
  for (const std::array<int, 3>& triangle : mesh.mesh->triangles) {
    const Vec3 a = corner(triangle[0]) - origin;
    const Vec3 b = corner(triangle[1]) - origin;
    const Vec3 c = corner(triangle[2]) - origin;
    const double six = a.dot(b.cross(c));
    six_volumes += six;
    moment += six * (a + b + c);
  }
  if (!(six_volumes > 0)) return std::nullopt;
  return Volume{six_volumes / 6, origin + moment / (4 * six_volumes)};
}

}  // namespace

std::optional<Volume> volume_of(const Shape& shape) {
  std::optional<Volume> found =
      std::visit([](const auto& solid) { return volume_in_shape(solid); }, shape.solid);
  if (found) found->centre = shape.X_BS * found->centre;
  return found;
}

std::optional<Volume> volume_of(const std::vector<Shape>& shapes) {
  if (shapes.empty()) return std::nullopt;
  Volume whole;
  Vec3 moment = Vec3::Zero();
  for (const Shape& shape : shapes) {
    const std::optional<Volume> one = volume_of(shape);
    if (!one) return std::nullopt;
    whole.volume += one->volume;
    moment += one->volume * one->centre;
  }
  if (!(whole.volume > 0)) return std::nullopt;
  whole.centre = moment / whole.volume;
  return whole;
}

}  // namespace rubicon::geometry
