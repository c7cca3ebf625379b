#include "tests/proof/solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rubicon::collision::proof {
namespace {

/// The distance of the origin from the nearest side of a convex polygon around it.
double inner_radius(const std::vector<Eigen::Vector2d>& polygon) {
  double radius = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d edge = (polygon[(i + 1) % polygon.size()] - polygon[i]).normalized();
    radius = std::min(radius, edge.y() * polygon[i].x() - edge.x() * polygon[i].y());
  }
  return radius;
}

}  // namespace

geometry::Shape Solid::shape() const {
  switch (kind) {
    case Kind::kBox:
      return {geometry::Box{-half, half}, Pose::Identity()};
    case Kind::kPrism:
      return {geometry::Prism{-half.z(), half.z(), polygon}, Pose::Identity()};
    case Kind::kSphere:
      return {geometry::Sphere{Vec3::Zero(), radius}, Pose::Identity()};
    case Kind::kCapsule:
      return {geometry::Capsule{Vec3(0, 0, -half_length), Vec3(0, 0, half_length), radius},
              Pose::Identity()};
    case Kind::kCylinder:
      break;
  }
  return {geometry::Cylinder{radius, -half_length, half_length}, Pose::Identity()};
}

Polytope Solid::polytope() const {
  return kind == Kind::kBox ? box_polytope(half) : prism_polytope(polygon, -half.z(), half.z());
}

double Solid::reach() const {
  switch (kind) {
    case Kind::kBox:
    case Kind::kPrism:
      return reach_of(polytope());
    case Kind::kSphere:
      return radius;
    case Kind::kCapsule:
      return radius + half_length;
    case Kind::kCylinder:
      break;
  }
  return std::sqrt(radius * radius + half_length * half_length);
}

double Solid::width() const {
  switch (kind) {
    case Kind::kBox:
    case Kind::kPrism:
      return polytope().width;
    case Kind::kSphere:
    case Kind::kCapsule:
      return 2 * radius;
    case Kind::kCylinder:
      break;
  }
  return 2 * std::min(radius, half_length);
}

FclGeometry Solid::fcl(double grow) const {
  switch (kind) {
    case Kind::kBox: {
      const Vec3 grown = half.array() + grow;
      return grown.minCoeff() > 0 ? fcl_box(grown) : nullptr;
    }
    case Kind::kPrism: {
      // Larger or smaller by a factor about the origin: no side moves by less than asked for.
      const double factor = 1 + grow / std::min(inner_radius(polygon), half.z());
      if (factor <= 0) return nullptr;
      std::vector<Eigen::Vector2d> scaled = polygon;
      for (Eigen::Vector2d& corner : scaled) corner *= factor;
      return fcl_prism(scaled, -half.z() * factor, half.z() * factor);
    }
    case Kind::kSphere:
      return radius + grow > 0 ? fcl_sphere(radius + grow) : nullptr;
    case Kind::kCapsule:
      return radius + grow > 0 ? fcl_capsule(radius + grow, half_length) : nullptr;
    case Kind::kCylinder:
      break;
  }
  if (std::min(radius, half_length) + grow <= 0) return nullptr;
  return fcl_cylinder(radius + grow, half_length + grow);
}

Solid box_solid(const Vec3& half) {
  Solid solid;
  solid.half = half;
  return solid;
}

Solid random_prism(Random& random, double size) {
  // Corners on an ellipse are convex; less than half a turn apart they go round the origin.
  Solid solid;
  solid.kind = Solid::Kind::kPrism;
  const int corners = 3 + random.below(6);
  const Vec3 axes = Vec3::Constant(size * 0.3) + 0.2 * size * (Vec3::Ones() + random.vector(1));
  const double first = random.between(0, 360);
  for (int i = 0; i < corners; ++i) {
    const double angle = first + (i + random.between(-0.2, 0.2)) * 360 / corners;
    solid.polygon.emplace_back(axes.x() * math::cos_deg(angle), axes.y() * math::sin_deg(angle));
  }
  solid.half = Vec3::Constant(random.between(0.05, 1) * size);
  return solid;
}

Solid random_solid(Random& random, double least, double greatest) {
  Solid solid;
  const int kind = random.below(5);
  if (kind == 1) return random_prism(random, greatest);
  solid.kind = static_cast<Solid::Kind>(kind);
  solid.half = Vec3{random.between(least, greatest), random.between(least, greatest),
                    random.between(least, greatest)};
  solid.radius = random.between(least, greatest);
  solid.half_length = random.between(least, greatest);
  return solid;
}

std::string text_of(const Solid& solid) {
  switch (solid.kind) {
    case Solid::Kind::kBox:
      return fmt::format("box of half {}", text_of(solid.half));
    case Solid::Kind::kPrism: {
      std::string corners;
      for (const Eigen::Vector2d& corner : solid.polygon)
        corners += fmt::format(" ({}, {})", corner.x(), corner.y());
      return fmt::format("prism of half height {} over{}", solid.half.z(), corners);
    }
    case Solid::Kind::kSphere:
      return fmt::format("sphere of radius {}", solid.radius);
    case Solid::Kind::kCapsule:
      return fmt::format("capsule of radius {} and half length {}", solid.radius,
                         solid.half_length);
    case Solid::Kind::kCylinder:
      break;
  }
  return fmt::format("cylinder of radius {} and half length {}", solid.radius, solid.half_length);
}

}  // namespace rubicon::collision::proof
