#include "src/motion/collision/mesh/mesh_inside.hpp"

#include <algorithm>
#include <limits>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/convex/convex.hpp"
#include "src/motion/collision/mesh/winding.hpp"

namespace rubicon::collision {
namespace {

/// Of larger meshes only so many triangles have a point half way, evenly taken.
constexpr std::size_t kMostMiddles = 1024;
/// Triangles of meshes of no more than these are looked under at four places, others at one.
constexpr std::size_t kFewTriangles = 1024;
/// What is thicker (m) is not thin by any contact tolerance: under triangles without such a point
/// nobody looks farther.
constexpr double kThick = 0.25;
/// The normals of triangles with a smaller altitude (m) are noise.
constexpr double kNoNormal = 1e-6;
/// The boxes around more parts than this are not compared.
constexpr std::size_t kManyParts = 256;

/// 1 if the normals of a closed soup point outwards, -1 if inwards.
double side_of_normals(const TriangleSoup& soup) {
  double volume = 0;
  for (int i = 0; i < static_cast<int>(soup.triangles().size()); ++i) {
    volume += soup.corner(i, 0).dot(soup.corner(i, 1).cross(soup.corner(i, 2)));
  }
  return volume < 0 ? -1 : 1;
}

/// Whether the boxes around some connected parts meet.
bool parts_may_overlap(const TriangleSoup& soup) {
  std::vector<Bounds> parts;
  const std::vector<int> part_of = connected_parts(soup.vertices().size(), soup.triangles());
  for (std::size_t i = 0; i < part_of.size(); ++i) {
    const auto part = static_cast<std::size_t>(part_of[i]);
    if (part >= parts.size()) parts.resize(part + 1);
    for (int k = 0; k < 3; ++k) parts[part].add(soup.corner(static_cast<int>(i), k));
  }
  if (parts.size() > kManyParts) return true;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!parts[i].disjoint(parts[j])) return true;
    }
  }
  return false;
}

}  // namespace

MeshInside::MeshInside(const TriangleSoup& soup) : soup_(&soup), grid_(soup) {
  const std::size_t count = soup.triangles().size();
  widths_.assign(count, std::numeric_limits<double>::infinity());
  const double side = soup.closed() ? side_of_normals(soup) : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const int triangle = static_cast<int>(i);
    const Vec3& a = soup.corner(triangle, 0);
    const Vec3& b = soup.corner(triangle, 1);
    const Vec3& c = soup.corner(triangle, 2);
    const bool is_needle = smallest_altitude(a, b, c) < kNoNormal;
    outwards_.push_back(is_needle ? Vec3(Vec3::Zero())
                                  : Vec3(side * (b - a).cross(c - a).normalized()));
  }
  if (!soup.closed()) return;
  is_plain_ = !parts_may_overlap(soup);
  const std::size_t stride = (count + kMostMiddles - 1) / kMostMiddles;
  for (std::size_t i = 0; i < count; ++i) {
    const int triangle = static_cast<int>(i);
    const Vec3& a = soup.corner(triangle, 0);
    const Vec3& b = soup.corner(triangle, 1);
    const Vec3& c = soup.corner(triangle, 2);
    if (outwards(triangle).isZero()) continue;
    const bool keep = i % stride == 0;
    look_under(triangle, (a + b + c) / 3.0, keep);
    if (count > kFewTriangles) continue;
    for (const Vec3& near : {a, b, c}) look_under(triangle, (a + b + c + 3 * near) / 6.0, keep);
  }
}

void MeshInside::look_under(int triangle, const Vec3& from, bool keep) {
  const Vec3 inwards = -outwards(triangle);
  double way = 0;
  // Surfaces may lie inside the solid where its parts overlap: as far as it goes on behind them.
  for (const double next : ways_to_surface(
           *soup_, from, inwards, keep ? std::numeric_limits<double>::infinity() : kThick)) {
    if (!holds(from + 0.5 * (way + next) * inwards)) break;
    if (way > 0) is_plain_ = false;
    way = next;
  }
  if (way == 0) return;
  double& width = widths_[static_cast<std::size_t>(triangle)];
  width = std::min(width, way);
  least_width_ = std::min(least_width_, way);
  const Vec3 middle = from + 0.5 * way * inwards;
  if (keep && holds(middle)) middles_.push_back({middle, way});
}

bool MeshInside::holds(const Vec3& point) const {
  switch (grid_.at(point)) {
    case InsideGrid::Cell::kOutside:
      return false;
    case InsideGrid::Cell::kInside:
      return true;
    case InsideGrid::Cell::kUnknown:
      break;
  }
  return winding_number(*soup_, point) != 0;
}

bool MeshInside::holds_deep(const Vec3& point, double depth) const {
  if (grid_.at(point) == InsideGrid::Cell::kOutside) return false;
  // First what is quick: points that touch the surface graze it on every ray.
  return !surface_within(*soup_, point, depth) && holds(point);
}

double MeshInside::allowed(int triangle, double contact_tolerance) const {
  const double width = widths_[static_cast<std::size_t>(triangle)];
  return std::max(std::min(contact_tolerance, thickness_tolerance(width)), kRoundingDepth);
}

double MeshInside::least_allowed(double contact_tolerance) const {
  return std::max(std::min(contact_tolerance, thickness_tolerance(least_width_)), kRoundingDepth);
}

}  // namespace rubicon::collision
