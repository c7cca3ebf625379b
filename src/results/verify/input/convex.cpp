#include "src/results/verify/input/convex.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace rubicon::verify {

namespace {

/// Length of an edge (m) below which it is none.
constexpr double kNoEdge = 1e-12;

/// Directions are added once; nearer than this (sine of the angle) they are one. At 100 m it is
/// 0.1 um.
constexpr double kSameDirection = 1e-9;

void add_direction(std::vector<Vec3>& list, const Vec3& direction) {
  const double length = direction.norm();
  if (!(length > kNoEdge)) return;
  const Vec3 unit = direction / length;
  for (const Vec3& known : list) {
    if (known.cross(unit).norm() < kSameDirection) return;
  }
  list.push_back(unit);
}

double extent(const std::vector<Vec3>& corners, const Vec3& n) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vec3& corner : corners) {
    least = std::min(least, n.dot(corner));
    most = std::max(most, n.dot(corner));
  }
  return most - least;
}

double altitude(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double doubled_area = (b - a).cross(c - a).norm();
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return longest > 0 ? doubled_area / longest : 0;
}

}  // namespace

Vec3 Convex::support(const Vec3& n) const {
  const Vec3* best = &corners.front();
  double most = n.dot(*best);
  for (const Vec3& corner : corners) {
    const double value = n.dot(corner);
    if (value > most) {
      most = value;
      best = &corner;
    }
  }
  Vec3 p = *best;
  if (ball > 0 && n.norm() > 0) p += n * (ball / n.norm());
  if (disc > 0) {
    const Vec3 across = n - disc_axis * disc_axis.dot(n);
    const double length = across.norm();
    if (length > kSameDirection * n.norm()) p += across * (disc / length);
  }
  return p;
}

Vec3 Convex::centre() const {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& corner : corners) sum += corner;
  return sum / static_cast<double>(corners.size());
}

Bounds Bounds::grown(double by) const {
  return {lower - Vec3::Constant(by), upper + Vec3::Constant(by)};
}

Bounds Bounds::placed(const Pose& X) const {
  const Vec3 middle = X * centre();
  const Vec3 half = X.linear().cwiseAbs() * ((upper - lower) / 2);
  return {middle - half, middle + half};
}

Bounds bounds_of(const Convex& piece) {
  Bounds bounds;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 n = Vec3::Unit(axis);
    bounds.lower[axis] = piece.support(-n)[axis];
    bounds.upper[axis] = piece.support(n)[axis];
  }
  return bounds;
}

Convex box_piece(const Vec3& lower, const Vec3& upper) {
  Convex piece;
  for (int i = 0; i < 8; ++i) {
    piece.corners.emplace_back((i & 1) != 0 ? upper.x() : lower.x(),
                               (i & 2) != 0 ? upper.y() : lower.y(),
                               (i & 4) != 0 ? upper.z() : lower.z());
  }
  piece.normals = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  piece.edges = piece.normals;
  piece.width = (upper - lower).minCoeff();
  return piece;
}

Convex triangle_piece(const Vec3& a, const Vec3& b, const Vec3& c) {
  Convex piece;
  piece.corners = {a, b, c};
  add_direction(piece.normals, (b - a).cross(c - a));
  for (const Vec3& edge : {Vec3(b - a), Vec3(c - b), Vec3(a - c)}) add_direction(piece.edges, edge);
  piece.width = altitude(a, b, c);
  return piece;
}

Convex prism_piece(const std::vector<Eigen::Vector2d>& polygon, double z0, double z1) {
  Convex piece;
  for (const Eigen::Vector2d& p : polygon) {
    piece.corners.emplace_back(p.x(), p.y(), z0);
    piece.corners.emplace_back(p.x(), p.y(), z1);
  }
  piece.normals = {Vec3::UnitZ()};
  piece.edges = {Vec3::UnitZ()};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
    add_direction(piece.edges, {side.x(), side.y(), 0});
    add_direction(piece.normals, {side.y(), -side.x(), 0});
  }
  piece.width = std::numeric_limits<double>::infinity();
  for (const Vec3& n : piece.normals) piece.width = std::min(piece.width, extent(piece.corners, n));
  if (piece.normals.size() + piece.edges.size() > kMostDirections) {
    piece.normals.clear();
    piece.edges.clear();
  }
  return piece;
}

Convex cylinder_piece(double radius, double z0, double z1) {
  Convex piece;
  piece.corners = {Vec3(0, 0, z0), Vec3(0, 0, z1)};
  piece.disc = radius;
  piece.width = std::min(2 * radius, z1 - z0);
  return piece;
}

Convex capsule_piece(const Vec3& a, const Vec3& b, double radius) {
  Convex piece;
  piece.corners = {a};
  if (a != b) piece.corners.push_back(b);
  piece.ball = radius;
  piece.width = 2 * radius;
  return piece;
}

Convex placed(Convex piece, const Pose& X) {
  for (Vec3& corner : piece.corners) corner = X * corner;
  for (Vec3& n : piece.normals) n = X.linear() * n;
  for (Vec3& edge : piece.edges) edge = X.linear() * edge;
  piece.disc_axis = X.linear() * piece.disc_axis;
  return piece;
}

}  // namespace rubicon::verify
