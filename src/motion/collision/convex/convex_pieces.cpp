#include "src/motion/collision/convex/convex_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "src/motion/collision/base/polygon.hpp"
#include "src/motion/collision/base/tolerances.hpp"

namespace rubicon::collision {
namespace {

void require_positive(double extent, const char* what) {
  if (!std::isfinite(extent))
    throw std::invalid_argument(fmt::format("the {} is not finite", what));
  if (!(extent > 0)) {
    throw std::invalid_argument(fmt::format("the {} is {}, expected more than 0", what, extent));
  }
}

void require_finite(const Vec3& point, const char* what) {
  if (!point.allFinite()) throw std::invalid_argument(fmt::format("{} is not finite", what));
}

/// The prism over a convex polygon (counter-clockwise).
ConvexPiece extruded(const Polygon& polygon, double z0, double z1, const Placement& X) {
  ConvexPiece piece;
  piece.normals.push_back(X.R.col(2));
  piece.edges.push_back(X.R.col(2));
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& corner = polygon[i];
    const Eigen::Vector2d side = (polygon[(i + 1) % polygon.size()] - corner).normalized();
    piece.vertices.push_back(X * Vec3(corner.x(), corner.y(), z0));
    piece.vertices.push_back(X * Vec3(corner.x(), corner.y(), z1));
    add_direction(piece.normals, X.R * Vec3(side.y(), -side.x(), 0));
    add_direction(piece.edges, X.R * Vec3(side.x(), side.y(), 0));
  }
  finish_polytope(piece);
  return piece;
}

/// Not by a list of initial values, which would copy it.
std::vector<ConvexPiece> alone(ConvexPiece piece) {
  std::vector<ConvexPiece> pieces;
  pieces.push_back(std::move(piece));
  return pieces;
}

}  // namespace

void add_direction(std::vector<Vec3>& directions, const Vec3& direction) {
  const bool known = std::any_of(directions.begin(), directions.end(), [&](const Vec3& other) {
    return other.cross(direction).norm() < kSameDirection;
  });
  if (!known) directions.push_back(direction);
}

void finish_polytope(ConvexPiece& piece) {
  piece.width = std::numeric_limits<double>::infinity();
  const Convex convex = piece.view();
  for (const Vec3& normal : piece.normals) {
    const Interval interval = convex.extent(normal);
    piece.width = std::min(piece.width, interval.greatest - interval.least);
  }
  piece.update_bounds();
}

std::vector<ConvexPiece> pieces_of(const geometry::Box& box, const Placement& X) {
  require_finite(box.lower, "a corner of a box");
  require_finite(box.upper, "a corner of a box");
  const Vec3 lower = box.lower.cwiseMin(box.upper);
  const Vec3 upper = box.lower.cwiseMax(box.upper);
  const char* names[] = {"length of a box along x", "length of a box along y",
                         "length of a box along z"};
  for (int axis = 0; axis < 3; ++axis) require_positive(upper[axis] - lower[axis], names[axis]);
  ConvexPiece piece;
  piece.vertices.reserve(8);
  for (int corner = 0; corner < 8; ++corner) {
    piece.vertices.push_back(X * Vec3((corner & 1) ? upper.x() : lower.x(),
                                      (corner & 2) ? upper.y() : lower.y(),
                                      (corner & 4) ? upper.z() : lower.z()));
  }
  piece.normals = {X.R.col(0), X.R.col(1), X.R.col(2)};
  piece.edges = piece.normals;
  finish_polytope(piece);
  return alone(std::move(piece));
}

std::vector<ConvexPiece> pieces_of(const geometry::Cylinder& cylinder, const Placement& X) {
  require_positive(cylinder.radius, "radius of a cylinder");
  require_positive(std::fabs(cylinder.z1 - cylinder.z0), "height of a cylinder");
  ConvexPiece piece;
  piece.vertices = {X * Vec3(0, 0, cylinder.z0), X * Vec3(0, 0, cylinder.z1)};
  piece.normals = {X.R.col(2)};
  piece.disc = cylinder.radius;
  piece.disc_axis = X.R.col(2);
  piece.width = std::min(2 * cylinder.radius, std::fabs(cylinder.z1 - cylinder.z0));
  piece.update_bounds();
  return alone(std::move(piece));
}

std::vector<ConvexPiece> pieces_of(const geometry::Sphere& sphere, const Placement& X) {
  require_positive(sphere.radius, "radius of a sphere");
  require_finite(sphere.centre, "the centre of a sphere");
  ConvexPiece piece;
  piece.vertices = {X * sphere.centre};
  piece.ball = sphere.radius;
  piece.width = 2 * sphere.radius;
  piece.update_bounds();
  return alone(std::move(piece));
}

std::vector<ConvexPiece> pieces_of(const geometry::Capsule& capsule, const Placement& X) {
  require_positive(capsule.radius, "radius of a capsule");
  require_finite(capsule.a, "an end of a capsule");
  require_finite(capsule.b, "an end of a capsule");
  ConvexPiece piece;
  piece.vertices = {X * capsule.a};
  if (capsule.a != capsule.b) {
    piece.vertices.push_back(X * capsule.b);
    piece.edges.push_back((piece.vertices[1] - piece.vertices[0]).normalized());
  }
  piece.ball = capsule.radius;
  piece.width = 2 * capsule.radius;
  piece.update_bounds();
  return alone(std::move(piece));
}

std::vector<ConvexPiece> pieces_of(const geometry::Prism& prism, const Placement& X) {
  require_positive(std::fabs(prism.z1 - prism.z0), "height of a prism");
  std::vector<ConvexPiece> pieces;
  double width = 0;
  for (const Polygon& part : convex_parts(simple_polygon(prism.polygon))) {
    pieces.push_back(extruded(part, prism.z0, prism.z1, X));
    width = std::max(width, pieces.back().width);
  }
  // The parts are one thing: a narrow part between two wide ones does not make it thin.
  for (ConvexPiece& piece : pieces) piece.width = width;
  return pieces;
}

}  // namespace rubicon::collision
