#pragma once

#include <array>
#include <vector>

namespace rubicon::guides {

/// A place of the plan view, m, and the heading there, from x towards y.
struct PlanePose {
  double x = 0;
  double y = 0;
  double heading_deg = 0;
};

/// One part of a way: an arc of the radius, or straight.
struct PlanePart {
  double turned_deg = 0;  ///< of the heading; left positive, right negative; straight 0
  double driven = 0;      ///< m; backwards negative
};

/// A way of a vehicle that turns no narrower than a radius and drives forwards and backwards.
struct ReedsSheppWay {
  std::vector<PlanePart> parts;
  /// m, backwards as well as forwards.
  double length() const;
};

/// Where a part leads from a pose.
PlanePose after(const PlanePose& from, const PlanePart& part);

/// The shortest way from one pose to another; of equally short ones the first in the order of
/// `reeds_shepp.cpp`. After J. A. Reeds, L. A. Shepp, "Optimal paths for a car that goes both
/// forwards and backwards", Pacific Journal of Mathematics 145, 1990, theorem 1 and section 8. Its
/// end is exact to rounding.
ReedsSheppWay reeds_shepp_way(const PlanePose& from, const PlanePose& to, double radius);

}  // namespace rubicon::guides
