#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "src/motion/math/pose.hpp"
#include "src/simulation/site/support_surface.hpp"

namespace rubicon::site {

/// A surface where it stands: only what looks down (of what rests) or up (of what carries).
struct StandingSurface {
  struct Facet {
    std::vector<Eigen::Vector2d> outline;  ///< seen from above, counter-clockwise, metres
    double z0 = 0;                         ///< height over the origin of the plane's (x, y),
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< and how it rises along x and y
    Eigen::Vector2d lower, upper;                     ///< the box around the outline
    double height(const Eigen::Vector2d& p) const { return z0 + slope.dot(p - origin); }
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  };
  std::vector<Facet> facets;
};
StandingSurface looking_down(const SupportSurface& surface, const math::Pose& X_WS);
StandingSurface looking_up(const SupportSurface& surface, const math::Pose& X_WS);

/// How one body rests on another.
struct Resting {
  std::vector<Eigen::Vector2d> points;  ///< corners of where they are in contact, seen from above
  /// m: where it is above the other and not in contact, by how much at least; infinite: nowhere.
  double distance = std::numeric_limits<double>::infinity();
  /// m: where it reaches below what it would rest on, by how much at least.
  double below = std::numeric_limits<double>::infinity();
};

/// In contact is what is from `depth` (m) below to `gap` (m) above the other's upper surface.
/// Contact that is narrower than `narrow` (m) as a whole carries nothing.
Resting rest(const StandingSurface& upper_body, const StandingSurface& lower_body, double gap,
             double depth, double narrow);

/// A part of where one body rests on another that lies in one plane.
struct ContactPatch {
  std::vector<math::Vec3> corners;          ///< of its convex hull, {W}, metres
  math::Vec3 normal = math::Vec3::UnitZ();  ///< unit, towards the upper body
};
/// The same contact in three dimensions, on the upper surface of the lower body.
std::vector<ContactPatch> contact_patches(const StandingSurface& upper_body,
                                          const StandingSurface& lower_body, double gap,
                                          double depth, double narrow);

/// The corners of the convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

/// m: how far p is inside of a convex polygon from its nearest side; negative: outside by so much.
double depth_in_polygon(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p);

/// What of a convex polygon (counter-clockwise) is `by` (m) inside of each of its sides; empty:
/// nothing.
std::vector<Eigen::Vector2d> inset(const std::vector<Eigen::Vector2d>& polygon, double by);

}  // namespace rubicon::site
