#include "src/exchange/building_io/element_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/pose.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::building_io {

namespace {

using Point = std::array<double, 2>;

/// Boxes whose areas differ by less than this share are equally small: models are drawn in single
/// precision, and a box has four edges of the same direction.
constexpr double kSameArea = 1e-4;
/// An angle this near to whole degrees (deg) is meant to be them.
constexpr double kNearWholeDegrees = 0.01;
/// Otherwise angles are given to this (deg): 0.1 mm at the end of a beam of 60 m.
constexpr double kAngleGrid = 1e-4;
/// Outlines with more corners than this are round, or made to take long: they lie along x.
constexpr std::size_t kMostHullCorners = 512;

double cross(const Point& o, const Point& a, const Point& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/// The convex hull of the outline, counterclockwise (Andrew, Another efficient algorithm for convex
/// hulls in two dimensions, 1979).
std::vector<Point> hull_of(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  for (const bool upper : {false, true}) {
    const std::size_t fixed = hull.size() + 1;
    for (const Point& p : points) {
      while (hull.size() > fixed && cross(hull[hull.size() - 2], hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    if (!upper) std::reverse(points.begin(), points.end());
  }
  return hull;
}

struct Extent {
  double low_x = HUGE_VAL, high_x = -HUGE_VAL, low_y = HUGE_VAL, high_y = -HUGE_VAL;
  double length() const { return high_x - low_x; }
  double width() const { return high_y - low_y; }
};

/// The extent of points along the unit vector (c, s) and across it.
Extent extent_along(const std::vector<Point>& points, double c, double s) {
  Extent extent;
  for (const Point& p : points) {
    const double x = c * p[0] + s * p[1];
    const double y = c * p[1] - s * p[0];
    extent.low_x = std::min(extent.low_x, x);
    extent.high_x = std::max(extent.high_x, x);
    extent.low_y = std::min(extent.low_y, y);
    extent.high_y = std::max(extent.high_y, y);
  }
  return extent;
}

/// The direction of the smallest box, deg.
double direction_of(const std::vector<Point>& hull) {
  if (hull.size() < 2 || hull.size() > kMostHullCorners) return 0;
  double best_area = HUGE_VAL;
  double best_edge = 0;
  double best = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point& a = hull[i];
    const Point& b = hull[(i + 1) % hull.size()];
    const double x = b[0] - a[0];
    const double y = b[1] - a[1];
    const double edge = std::sqrt(x * x + y * y);
    if (!(edge * kPlacesPerMetre > 1)) continue;
    const Extent extent = extent_along(hull, x / edge, y / edge);
    const double area = extent.length() * extent.width();
    const bool smaller = area < best_area * (1 - kSameArea);
    const bool as_small = area <= best_area * (1 + kSameArea);
    if (smaller || (as_small && edge > best_edge)) {
      best_area = std::min(area, best_area);
      best_edge = edge;
      best = math::atan2_deg(y, x);
    }
  }
  return best;
}

/// An angle as the plan says it, (-90, 90].
double readable(double degrees) {
  const double whole = std::round(degrees);
  const double angle = std::abs(degrees - whole) <= kNearWholeDegrees
                           ? whole
                           : std::round(degrees / kAngleGrid) * kAngleGrid;
  return math::normalised_axis_deg(angle) + 0.0;
}

double volume_of(const geometry::TriangleMesh& mesh) {
  if (!mesh.closed || mesh.vertices.empty()) return 0;
  // About a corner of its own: far from the origin the sum would lose digits.
  const Vec3 o = mesh.vertices.front();
  double six = 0;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) -> Vec3 {
      return mesh.vertices[static_cast<std::size_t>(t[k])] - o;
    };
    six += corner(0).dot(corner(1).cross(corner(2)));
  }
  return std::max(six / 6, 0.0);
}

}  // namespace

// Divided, so that it is the double nearest to the decimal number.
double on_grid(double metres) {
  return std::round(metres * kPlacesPerMetre) / kPlacesPerMetre + 0.0;
}

ElementFrame frame_of(const geometry::TriangleMesh& mesh) {
  ElementFrame frame;
  if (mesh.vertices.empty()) return frame;
  // Near its own corner, so that sums of squares keep their digits.
  const Vec3 o = mesh.vertices.front();
  std::vector<Point> outline;
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Vec3& p : mesh.vertices) {
    outline.push_back({p.x() - o.x(), p.y() - o.y()});
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  const std::vector<Point> hull = hull_of(std::move(outline));
  frame.turn_deg = readable(direction_of(hull));
  math::SineCosine turn = math::sine_cosine_deg(frame.turn_deg);
  Extent extent = extent_along(hull, turn.cosine, turn.sine);
  if (extent.width() > extent.length() * (1 + kSameArea)) {
    frame.turn_deg = readable(frame.turn_deg + 90);
    turn = math::sine_cosine_deg(frame.turn_deg);
    extent = extent_along(hull, turn.cosine, turn.sine);
  }
  const double x = (extent.low_x + extent.high_x) / 2;
  const double y = (extent.low_y + extent.high_y) / 2;
  frame.origin = {on_grid(o.x() + turn.cosine * x - turn.sine * y),
                  on_grid(o.y() + turn.sine * x + turn.cosine * y), on_grid(low)};
  frame.size = {on_grid(extent.length()), on_grid(extent.width()), on_grid(high - low)};
  frame.volume = volume_of(mesh);
  return frame;
}

geometry::TriangleMesh in_frame(const geometry::TriangleMesh& mesh, const ElementFrame& frame) {
  geometry::TriangleMesh result = mesh;
  const math::Pose back = math::rotation_z_deg(-frame.turn_deg);
  for (Vec3& p : result.vertices) p = back * (p - frame.origin);
  return result;
}

}  // namespace rubicon::building_io
