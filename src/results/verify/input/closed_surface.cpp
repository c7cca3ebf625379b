#include "src/results/verify/input/closed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/motion/math/angles.hpp"

namespace rubicon::verify {

namespace {

/// A ray that passes an edge nearer than this share of the triangle is not trusted.
constexpr double kGrazing = 1e-9;

/// Directions for rays: in no plane that buildings have.
const std::array<Vec3, 3>& ray_directions() {
  static const std::array<Vec3, 3> directions = {Vec3(0.613, 0.287, 0.736).normalized(),
                                                 Vec3(-0.371, 0.823, -0.43).normalized(),
                                                 Vec3(0.137, -0.511, -0.849).normalized()};
  return directions;
}

/// The solid angle of a triangle seen from the origin, in degrees of a half turn for 2 pi (van
/// Oosterom and Strackee, The solid angle of a plane triangle, 1983).
double solid_angle_deg(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2 * math::atan2_deg(a.dot(b.cross(c)), below);
}

/// Whether the ray meets the box, at any distance ahead.
bool ray_meets(const Vec3& from, const Vec3& direction, const Bounds& bounds) {
  double enter = 0;
  double leave = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double a = (bounds.lower[i] - from[i]) / direction[i];
    const double b = (bounds.upper[i] - from[i]) / direction[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave + kGrazing * (1 + std::fabs(leave));
}

}  // namespace

Vec3 nearest_of_triangle(const Vec3& p, const std::array<Vec3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  }
  const double sum = va + vb + vc;
  return a + ab * (vb / sum) + ac * (vc / sum);
}

ClosedSurface::ClosedSurface(std::vector<Vec3> vertices, std::vector<std::array<int, 3>> triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)) {
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    Bounds box;
    for (const Vec3& corner : corners(static_cast<int>(i))) box.add(corner);
    boxes.push_back(box);
  }
  tree_ = BoxTree(boxes);
}

std::array<Vec3, 3> ClosedSurface::corners(int triangle) const {
  const auto& [a, b, c] = triangles_[static_cast<std::size_t>(triangle)];
  const auto at = [&](int i) { return vertices_[static_cast<std::size_t>(i)]; };
  return {at(a), at(b), at(c)};
}

ClosedSurface::Crossings ClosedSurface::cross(const Vec3& from, const Vec3& direction) const {
  Crossings found;
  found.nearest = std::numeric_limits<double>::infinity();
  std::vector<int> open = {0};
  while (!open.empty()) {
    const BoxTree::Node& node = tree_.nodes()[static_cast<std::size_t>(open.back())];
    open.pop_back();
    if (!ray_meets(from, direction, node.bounds.grown(kGrazing))) continue;
    if (node.left >= 0) {
      open.push_back(node.left);
      open.push_back(node.right);
      continue;
    }
    const auto [a, b, c] = corners(node.item);
    const Vec3 n = (b - a).cross(c - a);
    const double size = n.norm();
    const double facing = n.dot(direction);
    // Volumes of the ray's line with each edge: all of one sign if it passes through.
    const double u = direction.dot((b - from).cross(c - from));
    const double v = direction.dot((c - from).cross(a - from));
    const double w = direction.dot((a - from).cross(b - from));
    const double least = std::min({u, v, w});
    const double most = std::max({u, v, w});
    if (least < -kGrazing * size && most > kGrazing * size) continue;
    const double along = n.dot(a - from) / facing;
    if (std::fabs(facing) > kGrazing * size && along < 0) continue;
    const bool inside = least > kGrazing * size || most < -kGrazing * size;
    if (!inside || !(std::fabs(facing) > kGrazing * size)) {
      found.grazing = true;
      continue;
    }
    found.winding += facing > 0 ? 1 : -1;
    found.nearest = std::min(found.nearest, along);
  }
  return found;
}

int ClosedSurface::winding(const Vec3& p) const {
  for (const Vec3& direction : ray_directions()) {
    const Crossings found = cross(p, direction);
    if (!found.grazing) return found.winding;
  }
  return winding_by_angles(p);
}

int ClosedSurface::winding_by_angles(const Vec3& p) const {
  double sum = 0;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto [a, b, c] = corners(static_cast<int>(i));
    sum += solid_angle_deg(a - p, b - p, c - p);
  }
  return static_cast<int>(std::floor(sum / 720 + 0.5));  // 4 pi are 720 degrees here
}

bool ClosedSurface::nearer_than(const Vec3& p, double distance) const {
  Bounds around;
  around.add(p);
  bool near = false;
  tree_.meeting(around.grown(distance), [&](int triangle) {
    near = near || (nearest_of_triangle(p, corners(triangle)) - p).norm() <= distance;
  });
  return near;
}

bool ClosedSurface::holds(const Vec3& p, double depth) const {
  Bounds point;
  point.add(p);
  if (empty() || !bounds().meets(point)) return false;
  return winding(p) != 0 && !nearer_than(p, depth);
}

std::vector<InnerPoint> ClosedSurface::inner_points(std::size_t count) const {
  std::vector<InnerPoint> points;
  const std::size_t stride =
      std::max<std::size_t>(1, triangles_.size() / std::max<std::size_t>(1, count));
  for (std::size_t i = 0; i < triangles_.size(); i += stride) {
    const auto [a, b, c] = corners(static_cast<int>(i));
    const Vec3 n = (b - a).cross(c - a);
    if (!(n.norm() > 0)) continue;
    const Vec3 inwards = -n.normalized();
    // Not the centroid: a ray from there often meets the edges of the other side.
    const Vec3 from = 0.36 * a + 0.33 * b + 0.31 * c;
    const double start = kGrazing * (1 + from.norm());
    const Crossings found = cross(from + inwards * start, inwards);
    if (!std::isfinite(found.nearest)) continue;
    const Vec3 p = from + inwards * (found.nearest / 2);
    if (winding(p) != 0) points.push_back({p, found.nearest});
  }
  return points;
}

}  // namespace rubicon::verify
