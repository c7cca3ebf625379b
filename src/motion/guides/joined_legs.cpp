#include <cmath>

#include "src/motion/guides/planners.hpp"

namespace rubicon::guides {

namespace {

/// Legs of a waypoint the same way if they differ by no more, weighted: rounding.
constexpr double kSameDirection = 1e-9;

/// Whether the leg that begins at point `end` only lengthens that from `first` to there.
bool goes_on(const Space& space, const std::vector<Point>& points, std::size_t first,
             std::size_t end) {
  const double before = space.distance(points[first], points[end]);
  const double after = space.distance(points[end], points[end + 1]);
  for (std::size_t i = 0; i < space.size(); ++i) {
    const double done = space.offset(points[first], points[end], i);
    const double next = space.offset(points[end], points[end + 1], i);
    const double whole = space.offset(points[first], points[end + 1], i);
    if (std::fabs(done / before - next / after) > kSameDirection) return false;
    if (std::fabs(done + next - whole) > kSameDirection * (1 + std::fabs(whole))) return false;
  }
  return true;
}

}  // namespace

std::vector<Point> joined_legs(Space& space, const std::vector<Point>& points) {
  if (points.empty()) return {};
  std::vector<Point> result{points.front()};
  for (std::size_t i = 0; i + 1 < points.size();) {
    std::size_t end = i + 1;
    while (end + 1 < points.size() && goes_on(space, points, i, end)) ++end;
    if (end > i + 1 && !space.leg_is_free(points[i], points[end])) end = i + 1;
    result.push_back(points[end]);
    i = end;
  }
  return result;
}

}  // namespace rubicon::guides
