#include "src/results/gltf/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/results/verify/input/fault.hpp"
#include "src/results/verify/input/polygon_parts.hpp"

namespace rubicon::gltf {

namespace {

using verify::Polygon;
using verify::ShapeData;

/// Facets round a circle: a pipe of 1 m radius is off by 5 mm at most.
constexpr int kFacets = 32;
/// Facets from a pole to the equator.
constexpr int kBands = 8;

/// m2: what is smaller has no normal.
constexpr double kLeastArea = 1e-12;

class TriangleCollector {
 public:
  TriangleCollector(const std::vector<verify::MeshData>& meshes) : meshes_(meshes) {}

  void add(const ShapeData& shape) {
    X_ = shape.X_BS;
    switch (shape.kind) {
      case ShapeData::Kind::box:
        add_prism({{shape.a.x(), shape.a.y()},
                   {shape.b.x(), shape.a.y()},
                   {shape.b.x(), shape.b.y()},
                   {shape.a.x(), shape.b.y()}},
                  shape.a.z(), shape.b.z());
        break;
      case ShapeData::Kind::cylinder:
        add_prism(circle(shape.radius), shape.z0, shape.z1);
        break;
      case ShapeData::Kind::prism:
        add_prism(shape.polygon, shape.z0, shape.z1);
        break;
      case ShapeData::Kind::sphere:
      case ShapeData::Kind::capsule:
        add_capsule(shape.a, shape.b, shape.radius);
        break;
      case ShapeData::Kind::mesh:
        add_mesh(meshes_[static_cast<std::size_t>(shape.mesh)]);
        break;
    }
  }

  std::size_t count() const { return triangles_.size(); }
  std::vector<Triangle> take() { return std::move(triangles_); }

 private:
  void add_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    if ((b - a).cross(c - a).norm() < 2 * kLeastArea) return;
    triangles_.push_back({X_ * a, X_ * b, X_ * c});
  }

  /// A fan of a convex polygon.
  void add_convex(const std::vector<Vec3>& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      add_triangle(corners[0], corners[i - 1], corners[i]);
    }
  }

  static Polygon circle(double radius) {
    Polygon corners;
    for (int i = 0; i < kFacets; ++i) {
      const auto [sine, cosine] = math::sine_cosine_deg(360.0 * i / kFacets);
      corners.emplace_back(radius * cosine, radius * sine);
    }
    return corners;
  }

  static double signed_area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d& a = polygon[i];
      const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
      twice += a.x() * b.y() - b.x() * a.y();
    }
    return twice / 2;
  }

  void add_prism(Polygon polygon, double z0, double z1) {
    if (signed_area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d& a = polygon[i];
      const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
      add_convex({{a.x(), a.y(), z0}, {b.x(), b.y(), z0}, {b.x(), b.y(), z1}, {a.x(), a.y(), z1}});
    }
    for (Polygon part : verify::convex_parts(polygon)) {
      if (signed_area(part) < 0) std::reverse(part.begin(), part.end());
      std::vector<Vec3> top, bottom;
      for (const Eigen::Vector2d& corner : part) top.emplace_back(corner.x(), corner.y(), z1);
      for (auto corner = part.rbegin(); corner != part.rend(); ++corner) {
        bottom.emplace_back(corner->x(), corner->y(), z0);
      }
      add_convex(top);
      add_convex(bottom);
    }
  }

  /// Half balls round a and b, and what is between; a sphere where they are one.
  void add_capsule(const Vec3& a, const Vec3& b, double radius) {
    const Vec3 along = b - a;
    const Vec3 z = along.norm() > 0 ? Vec3(along.normalized()) : Vec3(Vec3::UnitZ());
    const Vec3 x = z.unitOrthogonal();
    const Vec3 y = z.cross(x);
    std::vector<std::vector<Vec3>> rings;
    const auto add_ring = [&](const Vec3& centre, double latitude) {
      const auto [sine, cosine] = math::sine_cosine_deg(latitude);
      std::vector<Vec3> ring;
      for (const Eigen::Vector2d& corner : circle(radius * cosine)) {
        ring.push_back(centre + radius * sine * z + corner.x() * x + corner.y() * y);
      }
      rings.push_back(std::move(ring));
    };
    for (int i = -kBands; i <= 0; ++i) add_ring(a, 90.0 * i / kBands);
    for (int i = 0; i <= kBands; ++i) add_ring(b, 90.0 * i / kBands);
    for (std::size_t i = 1; i < rings.size(); ++i) {
      for (std::size_t k = 0; k < kFacets; ++k) {
        const std::size_t next = (k + 1) % kFacets;
        add_triangle(rings[i - 1][k], rings[i - 1][next], rings[i][next]);
        add_triangle(rings[i - 1][k], rings[i][next], rings[i][k]);
      }
    }
  }

  void add_mesh(const verify::MeshData& mesh) {
    for (const auto& triangle : mesh.triangles) {
      add_triangle(mesh.vertices[static_cast<std::size_t>(triangle[0])],
                   mesh.vertices[static_cast<std::size_t>(triangle[1])],
                   mesh.vertices[static_cast<std::size_t>(triangle[2])]);
    }
  }

  const std::vector<verify::MeshData>& meshes_;
  Pose X_ = Pose::Identity();
  std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> triangles_of(const std::vector<ShapeData>& shapes,
                                   const std::vector<verify::MeshData>& meshes, std::size_t most) {
  TriangleCollector collector(meshes);
  for (const ShapeData& shape : shapes) {
    collector.add(shape);
    if (collector.count() > most) {
      throw verify::UnreadableInput("expected fewer shapes: their triangles fill no film");
    }
  }
  return collector.take();
}

}  // namespace rubicon::gltf
