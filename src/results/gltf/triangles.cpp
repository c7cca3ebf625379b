#include "src/results/gltf/triangles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/results/gltf/polygon_parts.hpp"

namespace rubicon::gltf {

namespace {

/// Facets round a circle: a pipe of 1 m radius is off by 5 mm at most.
constexpr int kFacets = 32;
/// Facets from a pole to the equator.
constexpr int kBands = 8;

/// m2: what is smaller has no normal.
constexpr double kLeastArea = 1e-12;

void expect_extent(bool there, const char* kind) {
  if (!there) throw std::invalid_argument(fmt::format("expected a {} with an extent", kind));
}

class TriangleCollector {
 public:
  void add(const geometry::Shape& shape) {
    X_ = shape.X_BS;
    std::visit([&](const auto& solid) { add(solid); }, shape.solid);
  }

  std::size_t count() const { return triangles_.size(); }
  std::vector<Triangle> take() { return std::move(triangles_); }

 private:
  void add(const geometry::Box& box) {
    expect_extent(((box.upper - box.lower).array() > 0).all(), "box");
    add_prism({{box.lower.x(), box.lower.y()},
               {box.upper.x(), box.lower.y()},
               {box.upper.x(), box.upper.y()},
               {box.lower.x(), box.upper.y()}},
              box.lower.z(), box.upper.z());
  }

  void add(const geometry::Cylinder& cylinder) {
    expect_extent(cylinder.radius > 0 && cylinder.z1 > cylinder.z0, "cylinder");
    add_prism(circle(cylinder.radius), cylinder.z0, cylinder.z1);
  }

  void add(const geometry::Sphere& sphere) {
    expect_extent(sphere.radius > 0, "sphere");
    add_capsule(sphere.centre, sphere.centre, sphere.radius);
  }

  void add(const geometry::Capsule& capsule) {
    expect_extent(capsule.radius > 0, "capsule");
    add_capsule(capsule.a, capsule.b, capsule.radius);
  }

  void add(const geometry::Prism& prism) {
    expect_extent(prism.z1 > prism.z0, "prism");
    add_prism(prism.polygon, prism.z0, prism.z1);
  }

  void add(const geometry::Mesh& use) {
    const geometry::TriangleMesh& mesh = *use.mesh;
    for (const auto& triangle : mesh.triangles) {
      add_triangle(mesh.vertices[static_cast<std::size_t>(triangle[0])],
                   mesh.vertices[static_cast<std::size_t>(triangle[1])],
                   mesh.vertices[static_cast<std::size_t>(triangle[2])]);
    }
  }

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
    for (Polygon part : convex_parts(polygon)) {
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

  Pose X_ = Pose::Identity();
  std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> triangles_of(const std::vector<geometry::Shape>& shapes, std::size_t most) {
  TriangleCollector collector;
  for (const geometry::Shape& shape : shapes) {
    collector.add(shape);
    if (collector.count() > most) {
      throw std::invalid_argument("expected fewer shapes: their triangles fill no film");
    }
  }
  return collector.take();
}

}  // namespace rubicon::gltf
