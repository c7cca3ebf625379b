#include "src/simulation/site/support_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/motion/collision/base/polygon.hpp"
#include "src/motion/geometry/volume.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::site {

namespace {

using math::Vec3;

/// m: how far the facets of what is round may be inside of it.
constexpr double kSagitta = 1e-3;

/// Corners of a circle: the middle of a side is r (1 - cos(180 / n)) inside, about r (pi / n)^2
/// / 2.
int corners_of_circle(double radius) {
  const double needed = math::kPi * std::sqrt(std::max(radius, 0.0) / (2 * kSagitta));
  return 4 * static_cast<int>(std::ceil(std::clamp(needed, 48.0, 128.0) / 4));
}

class Builder {
 public:
  void add(const geometry::Shape& shape) {
    X_ = shape.X_BS;
    std::visit([this](const auto& solid) { this->add_solid(solid); }, shape.solid);
  }

  std::vector<SurfaceFacet> take() { return std::move(facets_); }

 private:
  /// Corners counter-clockwise as seen from outside.
  void facet(std::vector<Vec3> corners, bool two_sided = false) {
    Vec3 normal = Vec3::Zero();  // Newell's sum
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    }
    const double length = normal.norm();
    if (!(length > 0)) return;
    for (Vec3& corner : corners) corner = X_ * corner;
    facets_.push_back({std::move(corners), X_.linear() * (normal / length), two_sided});
  }

  /// Over a convex counter-clockwise polygon.
  void column(const collision::Polygon& polygon, double z0, double z1) {
    std::vector<Vec3> top, bottom;
    for (const Eigen::Vector2d& p : polygon) top.emplace_back(p.x(), p.y(), z1);
    for (auto p = polygon.rbegin(); p != polygon.rend(); ++p) {
      bottom.emplace_back(p->x(), p->y(), z0);
    }
    facet(std::move(top));
    facet(std::move(bottom));
  }

  void walls(const collision::Polygon& polygon, double z0, double z1) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d& a = polygon[i];
      const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
      facet({{a.x(), a.y(), z0}, {b.x(), b.y(), z0}, {b.x(), b.y(), z1}, {a.x(), a.y(), z1}});
    }
  }

  static collision::Polygon circle(double radius) {
    collision::Polygon polygon;
    const int n = corners_of_circle(radius);
    for (int i = 0; i < n; ++i) {
      const math::SineCosine at = math::sine_cosine_deg(360.0 * i / n);
      polygon.emplace_back(radius * at.cosine, radius * at.sine);
    }
    return polygon;
  }

  void add_solid(const geometry::Box& box) {
    const collision::Polygon base = {{box.lower.x(), box.lower.y()},
                                     {box.upper.x(), box.lower.y()},
                                     {box.upper.x(), box.upper.y()},
                                     {box.lower.x(), box.upper.y()}};
    column(base, box.lower.z(), box.upper.z());
    walls(base, box.lower.z(), box.upper.z());
  }

  void add_solid(const geometry::Prism& prism) {
    const collision::Polygon polygon = collision::simple_polygon(prism.polygon);
    for (const collision::Polygon& part : collision::convex_parts(polygon)) {
      column(part, prism.z0, prism.z1);
    }
    walls(polygon, prism.z0, prism.z1);
  }

  void add_solid(const geometry::Cylinder& cylinder) {
    const collision::Polygon base = circle(cylinder.radius);
    column(base, cylinder.z0, cylinder.z1);
    walls(base, cylinder.z0, cylinder.z1);
  }

  void add_solid(const geometry::Sphere& sphere) { ball(sphere.centre, sphere.radius); }

  /// Quadrangles between circles of latitude; those at the poles are triangles.
  void ball(const Vec3& centre, double radius) {
    const int n = corners_of_circle(radius);
    const auto point = [&](int latitude, int longitude) -> Vec3 {
      const math::SineCosine up = math::sine_cosine_deg(360.0 * latitude / n - 90);
      const math::SineCosine round = math::sine_cosine_deg(360.0 * longitude / n);
      return centre + radius * Vec3(up.cosine * round.cosine, up.cosine * round.sine, up.sine);
    };
    for (int i = 0; i < n / 2; ++i) {
      for (int k = 0; k < n; ++k) {
        std::vector<Vec3> corners = {point(i, k)};
        if (i > 0) corners.push_back(point(i, k + 1));
        corners.push_back(point(i + 1, k + 1));
        if (i + 1 < n / 2) corners.push_back(point(i + 1, k));
        facet(std::move(corners));
      }
    }
  }

  void add_solid(const geometry::Capsule& capsule) {
    ball(capsule.a, capsule.radius);
    ball(capsule.b, capsule.radius);
    const Vec3 axis = capsule.b - capsule.a;
    const double length = axis.norm();
    if (!(length > 0)) return;
    const Vec3 w = axis / length;
    const Vec3 u = w.cross(std::abs(w.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX()).normalized();
    const Vec3 v = w.cross(u);
    const collision::Polygon base = circle(capsule.radius);
    for (std::size_t i = 0; i < base.size(); ++i) {
      const Eigen::Vector2d& p = base[i];
      const Eigen::Vector2d& q = base[(i + 1) % base.size()];
      const Vec3 from = p.x() * u + p.y() * v;
      const Vec3 to = q.x() * u + q.y() * v;
      facet({capsule.a + from, capsule.a + to, capsule.b + to, capsule.b + from});
    }
  }

  void add_solid(const geometry::Mesh& mesh) {
    if (!mesh.mesh) return;
    for (const std::array<int, 3>& triangle : mesh.mesh->triangles) {
      const auto corner = [&](int i) {
        return mesh.mesh->vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>(i)])];
      };
      facet({corner(0), corner(1), corner(2)}, !mesh.mesh->closed);
    }
  }

  math::Pose X_ = math::Pose::Identity();
  std::vector<SurfaceFacet> facets_;
};

Vec3 centre_of_surface(const std::vector<SurfaceFacet>& facets) {
  double area = 0;
  Vec3 moment = Vec3::Zero();
  for (const SurfaceFacet& facet : facets) {
    for (std::size_t i = 1; i + 1 < facet.corners.size(); ++i) {
      const Vec3& a = facet.corners[0];
      const Vec3& b = facet.corners[i];
      const Vec3& c = facet.corners[i + 1];
      const double part = 0.5 * (b - a).cross(c - a).norm();
      area += part;
      moment += part * (a + b + c) / 3;
    }
  }
  return area > 0 ? Vec3(moment / area) : Vec3(Vec3::Zero());
}

}  // namespace

SupportSurfacePtr make_support_surface(const std::vector<geometry::Shape>& shapes) {
  if (shapes.empty()) return nullptr;
  Builder builder;
  for (const geometry::Shape& shape : shapes) builder.add(shape);
  auto surface = std::make_shared<SupportSurface>();
  surface->facets = builder.take();
  const auto volume = geometry::volume_of(shapes);
  surface->centre_of_mass = volume ? volume->centre : centre_of_surface(surface->facets);
  surface->lower = Vec3::Constant(std::numeric_limits<double>::infinity());
  surface->upper = -surface->lower;
  for (const SurfaceFacet& facet : surface->facets) {
    for (const Vec3& corner : facet.corners) {
      surface->lower = surface->lower.cwiseMin(corner);
      surface->upper = surface->upper.cwiseMax(corner);
    }
  }
  return surface;
}

}  // namespace rubicon::site
