#include "src/simulation/site/load_chart.hpp"

#include <cmath>
#include <limits>

namespace rubicon::site {

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

double chart_radius(const math::Pose& X_WM, const math::Vec3& p_WT) {
  const math::Vec3 p_MT = X_WM.inverse(Eigen::Isometry) * p_WT;
  return std::sqrt(p_MT.x() * p_MT.x() + p_MT.y() * p_MT.y());
}

}  // namespace rubicon::site
