#include "src/motion/collision/convex/convex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/motion/collision/base/tolerances.hpp"

namespace rubicon::collision {
namespace {

double disc_extent(const Convex& convex, const Vec3& n) {
  return convex.disc * (n - n.dot(convex.disc_axis) * convex.disc_axis).norm();
}

/// Which of the axes a vector is; -1: none.
int axis_of(const Vec3& n) {
  for (int axis = 0; axis < 3; ++axis) {
    if (n[axis] == 1) return n[(axis + 1) % 3] == 0 && n[(axis + 2) % 3] == 0 ? axis : -1;
  }
  return -1;
}

}  // namespace

Vec3 Convex::core_support(const Vec3& n) const {
  const Vec3* best = &vertices.front();
  double greatest = n.dot(*best);
  for (const Vec3& vertex : vertices.subspan(1)) {
    const double value = n.dot(vertex);
    if (value > greatest) {
      greatest = value;
      best = &vertex;
    }
  }
  if (disc == 0) return *best;
  const Vec3 across = n - n.dot(disc_axis) * disc_axis;
  const double length = across.norm();
  if (length < kParallel) return *best;
  return *best + across * (disc / length);
}

Interval Convex::extent(const Vec3& n) const {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  const auto reach = [&](double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  };
  // Most directions are axes of the drawing.
  const int axis = axis_of(n);
  if (axis >= 0) {
    for (const Vec3& vertex : vertices) reach(vertex[axis]);
  } else {
    for (const Vec3& vertex : vertices) reach(n.dot(vertex));
  }
  const double grown = ball + (disc > 0 ? disc_extent(*this, n) : 0.0);
  return {least - grown, greatest + grown};
}

double Convex::radius_about(const Vec3& axis, const Vec3& point) const {
  double greatest = 0;
  for (const Vec3& vertex : vertices) {
    greatest = std::max(greatest, axis.cross(vertex - point).norm());
  }
  const bool disc_turns_in_itself = disc_axis.cross(axis).norm() < kParallel;
  return disc > 0 && !disc_turns_in_itself ? greatest + disc : greatest;
}

Convex ConvexPiece::view() const {
  return {vertices, normals, edges, ball, disc, disc_axis, bounds, width};
}

void ConvexPiece::update_bounds() {
  const Convex convex = view();
  for (int axis = 0; axis < 3; ++axis) {
    const Interval interval = convex.extent(Vec3::Unit(axis));
    bounds.lower[axis] = interval.least;
    bounds.upper[axis] = interval.greatest;
  }
}

TrianglePiece::TrianglePiece(const Vec3& a, const Vec3& b, const Vec3& c)
    : vertices_{a, b, c},
      normal_{(b - a).cross(c - a).normalized()},
      edges_{(b - a).normalized(), (c - b).normalized(), (a - c).normalized()} {
  view_.vertices = vertices_;
  view_.normals = normal_;
  view_.edges = edges_;
  for (const Vec3& vertex : vertices_) view_.bounds.add(vertex);
  view_.width = smallest_altitude(a, b, c);
}

double smallest_altitude(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  if (longest == 0) return 0;
  return (b - a).cross(c - a).norm() / longest;
}

}  // namespace rubicon::collision
