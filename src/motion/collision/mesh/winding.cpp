#include "src/motion/collision/mesh/winding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::collision {
namespace {

/// A crossing nearer than this share of the triangle to its rim counts as grazing.
constexpr double kGrazing = 1e-9;

/// Directions without any relation to each other or to right angles; the first that grazes nothing
/// is used.
const std::array<Vec3, 4>& ray_directions() {
  static const std::array<Vec3, 4> directions = {
      Vec3(0.8017, 0.3391, 0.4923).normalized(), Vec3(-0.3713, 0.8629, 0.3431).normalized(),
      Vec3(0.2411, -0.4547, 0.8573).normalized(), Vec3(-0.5779, -0.6151, -0.5363).normalized()};
  return directions;
}

bool ray_meets(const Bounds& bounds, const Vec3& from, const Vec3& direction,
               double reach = std::numeric_limits<double>::infinity()) {
  double enter = 0;
  double leave = reach;
  for (int axis = 0; axis < 3; ++axis) {
    double first = (bounds.lower[axis] - kBoundsMargin - from[axis]) / direction[axis];
    double second = (bounds.upper[axis] + kBoundsMargin - from[axis]) / direction[axis];
    if (first > second) std::swap(first, second);
    enter = std::max(enter, first);
    leave = std::min(leave, second);
  }
  return enter <= leave;
}

/// +1 or -1 where the ray crosses the triangle, 0 where it misses, nothing where it grazes the rim
/// or the plane.
std::optional<int> crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& from,
                            const Vec3& direction) {
  // Moeller and Trumbore 1997.
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 across = direction.cross(ac);
  const double volume = ab.dot(across);
  if (std::fabs(volume) <= kGrazing * ab.norm() * ac.norm()) {
    // The ray lies in the plane or nearly so; only a ray that passes far from the triangle is known
    // to miss it.
    const Vec3 centre = (a + b + c) / 3.0;
    const Vec3 offset = centre - from;
    const double radius = std::sqrt(std::max(
        {(a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm()}));
    if ((offset - direction * direction.dot(offset)).norm() > 2 * radius) return 0;
    return std::nullopt;
  }
  const Vec3 arm = from - a;
  const double share_b = arm.dot(across) / volume;
  const Vec3 other = arm.cross(ab);
  const double share_c = direction.dot(other) / volume;
  const double least = std::min({share_b, share_c, 1 - share_b - share_c});
  if (least < -kGrazing) return 0;
  if (ac.dot(other) / volume < 0) return 0;
  if (least <= kGrazing) return std::nullopt;
  return volume > 0 ? -1 : 1;
}

std::optional<int> crossings(const TriangleSoup& soup, const Vec3& from, const Vec3& direction) {
  int sum = 0;
  const bool grazes = soup.any_triangle(
      [&](const Bounds& bounds) { return ray_meets(bounds, from, direction); },
      [&](int i) {
        const std::optional<int> one =
            crossing(soup.corner(i, 0), soup.corner(i, 1), soup.corner(i, 2), from, direction);
        sum += one.value_or(0);
        return !one;
      });
  return grazes ? std::nullopt : std::optional(sum);
}

/// van Oosterom and Strackee 1983.
int winding_by_angles(const TriangleSoup& soup, const Vec3& point) {
  double degrees = 0;
  for (int i = 0; i < static_cast<int>(soup.triangles().size()); ++i) {
    const Vec3 a = soup.corner(i, 0) - point;
    const Vec3 b = soup.corner(i, 1) - point;
    const Vec3 c = soup.corner(i, 2) - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    degrees += 2 * math::atan2_deg(a.dot(b.cross(c)),
                                   la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return static_cast<int>(std::floor(degrees / 720.0 + 0.5));
}

double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 edge = b - a;
  const double share = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (p - a - share * edge).squaredNorm();
}

double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const bool above = normal.dot((b - a).cross(p - a)) >= 0 &&
                     normal.dot((c - b).cross(p - b)) >= 0 && normal.dot((a - c).cross(p - c)) >= 0;
  if (above) {
    const double height = normal.dot(p - a);
    return height * height / normal.squaredNorm();
  }
  return std::min({squared_distance_to_segment(p, a, b), squared_distance_to_segment(p, b, c),
                   squared_distance_to_segment(p, c, a)});
}

}  // namespace

int winding_number(const TriangleSoup& soup, const Vec3& point) {
  for (const Vec3& direction : ray_directions()) {
    if (const std::optional<int> winding = crossings(soup, point, direction)) return *winding;
  }
  return winding_by_angles(soup, point);
}

bool surface_within(const TriangleSoup& soup, const Vec3& point, double distance) {
  return soup.any_triangle(
      [&](Bounds bounds) {
        bounds.grow(Vec3::Constant(distance));
        return bounds.contains(point);
      },
      [&](int i) {
        return squared_distance(point, soup.corner(i, 0), soup.corner(i, 1), soup.corner(i, 2)) <=
               distance * distance;
      });
}

std::vector<double> ways_to_surface(const TriangleSoup& soup, const Vec3& from,
                                    const Vec3& direction, double reach) {
  std::vector<double> ways;
  soup.any_triangle([&](const Bounds& bounds) { return ray_meets(bounds, from, direction, reach); },
                    [&](int i) {
                      const Vec3& a = soup.corner(i, 0);
                      const Vec3 ab = soup.corner(i, 1) - a;
                      const Vec3 ac = soup.corner(i, 2) - a;
                      const Vec3 across = direction.cross(ac);
                      const double volume = ab.dot(across);
                      if (volume == 0) return false;
                      const Vec3 arm = from - a;
                      const Vec3 other = arm.cross(ab);
                      const double share_b = arm.dot(across) / volume;
                      const double share_c = direction.dot(other) / volume;
                      const double way = ac.dot(other) / volume;
                      // A ray through an edge must not pass between the two triangles.
                      const double least = std::min({share_b, share_c, 1 - share_b - share_c});
                      if (least >= -kGrazing && way > kBoundsMargin && way <= reach)
                        ways.push_back(way);
                      return false;
                    });
  std::sort(ways.begin(), ways.end());
  const auto same = [](double a, double b) { return b - a < kBoundsMargin; };
  ways.erase(std::unique(ways.begin(), ways.end(), same), ways.end());
  return ways;
}

}  // namespace rubicon::collision
