#include "src/simulation/site/load_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/motion/collision/sweep/motion_bounds.hpp"

namespace rubicon::site {

namespace {

/// m: rounding of a radius along a step that keeps it. A load at the limit of its chart must still
/// be allowed to turn.
constexpr double kRadiusRounding = 1e-9;

/// m: how exactly the radius of a load is known. Poses and joint values are rounded: the same place
/// turned about the machine has a radius that is some 1e-15 of it more or less.
constexpr double kRadiusTolerance = 1e-6;

/// kg: rounding of masses, which are products of volumes, densities and units.
constexpr double kMassTolerance = 1e-6;

/// m: what lies between two looked at radii so near to each other is as they are.
constexpr double kRadiusResolution = 1e-3;

/// Halvings of a step, for motions without a useful bound.
constexpr int kMostHalvings = 24;

/// A step of a loaded machine, seen by its load chart.
class LoadedStep {
 public:
  LoadedStep(const std::vector<robot::CapacityPoint>& chart, double mass, const math::Pose& X_WM,
             const geometry::Motion& X_WT)
      : chart_(chart), mass_(mass), X_MW_(X_WM.inverse(Eigen::Isometry)), X_WT_(X_WT) {}

  bool is_allowed() {
    const Place start = place(0);
    const Place end = place(1);
    radius_at_start_ = start.norm();
    capacity_at_start_ = capacity_near(chart_, radius_at_start_);
    return allows(end.norm()) && allows_between(0, start, 1, end, 0);
  }

 private:
  /// Beside the axis of the mounting, m.
  using Place = Eigen::Vector2d;

  Place place(double s) const { return (X_MW_ * X_WT_.pose(s).translation()).head<2>(); }

  bool allows(double radius) const {
    return std::fabs(radius - radius_at_start_) <= kRadiusRounding ||
           may_hang(chart_, mass_, radius) || allows_all(radius, radius);
  }

  /// All radii of an interval.
  bool allows_all(double inner, double outer) const {
    const double capacity = least_capacity(chart_, inner, outer);
    if (mass_ <= capacity + kMassTolerance) return true;
    if (capacity_at_start_ + kMassTolerance >= mass_) return false;
    return capacity > capacity_at_start_ ||
           (capacity == capacity_at_start_ && outer < radius_at_start_);
  }

  bool allows_between(double s0, const Place& from, double s1, const Place& to,
                      int halvings) const {
    const double deviation = collision::chord_deviation_of(X_WT_, {}, s0, s1).centre;
    const Place along = to - from;
    const double length2 = along.squaredNorm();
    const double nearest = length2 > 0 ? std::clamp(-from.dot(along) / length2, 0.0, 1.0) : 0.0;
    const double inner = std::max((from + nearest * along).norm() - deviation, 0.0);
    const double outer = std::max(from.norm(), to.norm()) + deviation;
    if (allows_all(inner, outer)) return true;
    if (outer - inner <= kRadiusResolution || halvings == kMostHalvings) return true;
    const double s = (s0 + s1) / 2;
    const Place middle = place(s);
    return allows(middle.norm()) && allows_between(s0, from, s, middle, halvings + 1) &&
           allows_between(s, middle, s1, to, halvings + 1);
  }

  const std::vector<robot::CapacityPoint>& chart_;
  double mass_;
  math::Pose X_MW_;
  const geometry::Motion& X_WT_;
  double radius_at_start_ = 0;
  double capacity_at_start_ = 0;
};

/// capacity_at where it has its extremes: at the ends and at the points of the chart between.
template <class Better>
double extreme_capacity(const std::vector<robot::CapacityPoint>& chart, double inner, double outer,
                        Better better) {
  double found = better(capacity_at(chart, inner), capacity_at(chart, outer));
  for (const robot::CapacityPoint& point : chart) {
    if (point.radius > inner && point.radius < outer) found = better(found, point.mass);
  }
  return found;
}

}  // namespace

double capacity_at(const std::vector<robot::CapacityPoint>& chart, double radius) {
  if (chart.empty()) return std::numeric_limits<double>::infinity();
  if (radius <= chart.front().radius) return chart.front().mass;
  for (std::size_t i = 1; i < chart.size(); ++i) {
    const robot::CapacityPoint& inner = chart[i - 1];
    const robot::CapacityPoint& outer = chart[i];
    if (radius > outer.radius || outer.radius <= inner.radius) continue;
    const double part = (radius - inner.radius) / (outer.radius - inner.radius);
    return inner.mass + part * (outer.mass - inner.mass);
  }
  return 0;
}

double least_capacity(const std::vector<robot::CapacityPoint>& chart, double inner, double outer) {
  return extreme_capacity(chart, inner, outer, [](double a, double b) { return std::min(a, b); });
}

double most_capacity(const std::vector<robot::CapacityPoint>& chart, double inner, double outer) {
  return extreme_capacity(chart, inner, outer, [](double a, double b) { return std::max(a, b); });
}

double capacity_near(const std::vector<robot::CapacityPoint>& chart, double radius) {
  return most_capacity(chart, radius - kRadiusTolerance, radius + kRadiusTolerance);
}

bool may_hang(const std::vector<robot::CapacityPoint>& chart, double mass, double radius) {
  return may_hang_between(chart, mass, radius, radius);
}

bool may_hang_between(const std::vector<robot::CapacityPoint>& chart, double mass, double inner,
                      double outer) {
  const double most = most_capacity(chart, inner - kRadiusTolerance, outer + kRadiusTolerance);
  return mass <= most + kMassTolerance;
}

bool allows_step(const std::vector<robot::CapacityPoint>& chart, double mass,
                 const math::Pose& X_WM, const geometry::Motion& X_WT) {
  return chart.empty() || mass <= 0 || LoadedStep(chart, mass, X_WM, X_WT).is_allowed();
}

double chart_radius(const math::Pose& X_WM, const math::Vec3& p_WT) {
  const math::Vec3 p_MT = X_WM.inverse(Eigen::Isometry) * p_WT;
  return std::sqrt(p_MT.x() * p_MT.x() + p_MT.y() * p_MT.y());
}

}  // namespace rubicon::site
