#include "src/simulation/site/resting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubicon::site {

namespace {

using Point = Eigen::Vector2d;
using Points = std::vector<Point>;

/// Steeper than this (the upward part of the normal; 84 degrees) nothing rests on it.
constexpr double kSteep = 0.1;

/// m: corners that are nearer to each other are one. Reason: the direction of so short a side is
/// rounding.
constexpr double kShortSide = 1e-5;

/// m2: what is left of two facets that only have a line in common.
constexpr double kNoArea = 1e-9;

double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

double area_of(const Points& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return twice / 2;
}

/// What of a convex polygon is where `value`, linear along its sides, is not negative (Sutherland,
/// Hodgman 1974).
template <typename Value>
Points clipped(const Points& polygon, const Value& value) {
  Points result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double at_a = value(a);
    const double at_b = value(b);
    if (at_a >= 0) result.push_back(a);
    if ((at_a < 0) != (at_b < 0)) result.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return result;
}

StandingSurface looking(const SupportSurface& surface, const math::Pose& X_WS, double way) {
  StandingSurface result;
  for (const SurfaceFacet& facet : surface.facets) {
    const math::Vec3 normal = X_WS.linear() * facet.normal;
    const double up = normal.z() * way;
    if (!(up > kSteep || (facet.two_sided && up < -kSteep))) continue;
    StandingSurface::Facet& made = result.facets.emplace_back();
    for (const math::Vec3& corner : facet.corners) {
      made.outline.emplace_back((X_WS * corner).head<2>());
    }
    if (area_of(made.outline) < 0) std::reverse(made.outline.begin(), made.outline.end());
    const math::Vec3 first = X_WS * facet.corners[0];
    made.origin = first.head<2>();
    made.z0 = first.z();
    made.slope = -normal.head<2>() / normal.z();
    made.lower = made.upper = made.outline[0];
    for (const Point& p : made.outline) {
      made.lower = made.lower.cwiseMin(p);
      made.upper = made.upper.cwiseMax(p);
    }
  }
  return result;
}

Points common_outline(const StandingSurface::Facet& a, const StandingSurface::Facet& b) {
  Points polygon = a.outline;
  for (std::size_t i = 0; i < b.outline.size() && polygon.size() > 2; ++i) {
    const Point& from = b.outline[i];
    const Point along = b.outline[(i + 1) % b.outline.size()] - from;
    polygon = clipped(polygon, [&](const Point& p) { return cross(along, p - from); });
  }
  return polygon;
}

/// The facets of a body that are under or over another, in the order of x.
std::vector<const StandingSurface::Facet*> near(const StandingSurface& body,
                                                const StandingSurface& other) {
  Point lower = Point::Constant(std::numeric_limits<double>::infinity());
  Point upper = -lower;
  for (const StandingSurface::Facet& facet : other.facets) {
    lower = lower.cwiseMin(facet.lower);
    upper = upper.cwiseMax(facet.upper);
  }
  std::vector<const StandingSurface::Facet*> found;
  for (const StandingSurface::Facet& facet : body.facets) {
    if ((facet.lower.array() > upper.array()).any()) continue;
    if ((facet.upper.array() < lower.array()).any()) continue;
    found.push_back(&facet);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto* a, const auto* b) { return a->lower.x() < b->lower.x(); });
  return found;
}

/// Of a convex polygon.
double width_of(const Points& hull) {
  if (hull.size() < 3) return 0;
  double width = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point along = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
    double farthest = 0;
    for (const Point& p : hull) farthest = std::max(farthest, cross(along, p - hull[i]));
    width = std::min(width, farthest);
  }
  return width;
}

}  // namespace

StandingSurface looking_down(const SupportSurface& surface, const math::Pose& X_WS) {
  return looking(surface, X_WS, -1);
}

StandingSurface looking_up(const SupportSurface& surface, const math::Pose& X_WS) {
  return looking(surface, X_WS, 1);
}

namespace {

/// Calls `each(common, over, under)` with the outline that two facets have in common.
template <typename Each>
void for_common(const StandingSurface& upper_body, const StandingSurface& lower_body,
                const Each& each) {
  const std::vector<const StandingSurface::Facet*> under_it = near(lower_body, upper_body);
  for (const StandingSurface::Facet& over : upper_body.facets) {
    for (const StandingSurface::Facet* candidate : under_it) {
      const StandingSurface::Facet& under = *candidate;
      if (under.lower.x() > over.upper.x()) break;
      if (under.upper.x() < over.lower.x() || over.lower.y() > under.upper.y() ||
          under.lower.y() > over.upper.y()) {
        continue;
      }
      const Points common = common_outline(over, under);
      if (common.size() < 3 || area_of(common) < kNoArea) continue;
      each(common, over, under);
    }
  }
}

/// What of the outline is in contact; less than three points: nothing.
Points in_contact(const Points& common, const StandingSurface::Facet& over,
                  const StandingSurface::Facet& under, double gap, double depth) {
  const auto above = [&](const Point& p) { return over.height(p) - under.height(p); };
  Points contact = clipped(common, [&](const Point& p) { return gap - above(p); });
  contact = clipped(contact, [&](const Point& p) { return above(p) + depth; });
  if (contact.size() < 3 || area_of(contact) < kNoArea) contact.clear();
  return contact;
}

}  // namespace

Resting rest(const StandingSurface& upper_body, const StandingSurface& lower_body, double gap,
             double depth, double narrow) {
  Resting result;
  for_common(upper_body, lower_body,
             [&](const Points& common, const auto& over, const auto& under) {
               double least = std::numeric_limits<double>::infinity();
               double most = -least;
               for (const Point& p : common) {
                 const double above = over.height(p) - under.height(p);
                 least = std::min(least, above);
                 most = std::max(most, above);
               }
               if (least > gap) {
                 result.distance = std::min(result.distance, least);
               } else if (most < -depth) {
                 result.below = std::min(result.below, -most);
               } else {
                 const Points contact = in_contact(common, over, under, gap, depth);
                 result.points.insert(result.points.end(), contact.begin(), contact.end());
               }
             });
  if (!result.points.empty()) {
    result.points = convex_hull(std::move(result.points));
    if (width_of(result.points) <= narrow) result.points.clear();
  }
  return result;
}

std::vector<ContactPatch> contact_patches(const StandingSurface& upper_body,
                                          const StandingSurface& lower_body, double gap,
                                          double depth, double narrow) {
  /// Facets of the lower body in one plane, with slopes and heights equal to so much.
  constexpr double kSame = 1e-6;
  struct Plane {
    const StandingSurface::Facet* facet;
    Points points;
  };
  std::vector<Plane> planes;
  Points all;
  for_common(
      upper_body, lower_body, [&](const Points& common, const auto& over, const auto& under) {
        const Points contact = in_contact(common, over, under, gap, depth);
        if (contact.empty()) return;
        all.insert(all.end(), contact.begin(), contact.end());
        const auto same = std::find_if(planes.begin(), planes.end(), [&](const Plane& plane) {
          return (plane.facet->slope - under.slope).norm() < kSame &&
                 std::abs(plane.facet->height(under.origin) - under.z0) < kSame;
        });
        Plane& plane = same == planes.end() ? planes.emplace_back(Plane{&under, {}}) : *same;
        plane.points.insert(plane.points.end(), contact.begin(), contact.end());
      });
  std::vector<ContactPatch> patches;
  if (all.empty() || width_of(convex_hull(std::move(all))) <= narrow) return patches;
  for (Plane& plane : planes) {
    ContactPatch& patch = patches.emplace_back();
    for (const Point& p : convex_hull(std::move(plane.points))) {
      patch.corners.emplace_back(p.x(), p.y(), plane.facet->height(p));
    }
    patch.normal = math::Vec3(-plane.facet->slope.x(), -plane.facet->slope.y(), 1).normalized();
  }
  return patches;
}

std::vector<Point> convex_hull(std::vector<Point> points) {
  const auto less = [](const Point& a, const Point& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Points hull;
  const auto add = [&](const Point& p, std::size_t kept) {
    while (hull.size() >= kept + 2 &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Point& p : points) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.pop_back();
  return hull;
}

double depth_in_polygon(const std::vector<Point>& polygon, const Point& p) {
  if (polygon.empty()) return -std::numeric_limits<double>::infinity();
  double inside = std::numeric_limits<double>::infinity();
  double outside = inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point side = polygon[(i + 1) % polygon.size()] - a;
    const double length = side.norm();
    if (length > 0) inside = std::min(inside, cross(side / length, p - a));
    const double along = length > 0 ? std::clamp(side.dot(p - a) / (length * length), 0.0, 1.0) : 0;
    outside = std::min(outside, (p - a - along * side).norm());
  }
  return polygon.size() > 2 && inside >= 0 ? inside : -outside;
}

std::vector<Point> inset(const std::vector<Point>& polygon, double by) {
  Points corners;
  for (const Point& p : polygon) {
    if (corners.empty() || (p - corners.back()).norm() > kShortSide) corners.push_back(p);
  }
  while (corners.size() > 1 && (corners.front() - corners.back()).norm() <= kShortSide) {
    corners.pop_back();
  }
  if (corners.size() < 3) return {};
  Points inner = corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point along = (corners[(i + 1) % corners.size()] - a).normalized();
    inner = clipped(inner, [&](const Point& p) { return cross(along, p - a) - by; });
  }
  return inner;
}

}  // namespace rubicon::site
