#include "tests/unit/collision/box_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rubicon::collision::test {
namespace {

double radius(const OracleBox& box, const Vec3& axis) {
  return (box.X_WC.linear().transpose() * axis).cwiseAbs().dot(box.half);
}

double least_overlap(const OracleBox& a, const OracleBox& b, const std::vector<Vec3>& axes,
                     const Vec3& d) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& raw : axes) {
    if (raw.norm() < 1e-9) continue;
    const Vec3 axis = raw.normalized();
    const double sum = radius(a, axis) + radius(b, axis);
    // a's centre runs over [first, last] along the axis, b's centre is 0.
    const double first = axis.dot(a.X_WC.translation() - b.X_WC.translation());
    const double last = first + axis.dot(d);
    least = std::min(least, sum + std::max(first, last));
    least = std::min(least, sum - std::min(first, last));
  }
  return least;
}

std::vector<Vec3> pose_axes(const OracleBox& a, const OracleBox& b) {
  std::vector<Vec3> axes;
  for (int i = 0; i < 3; ++i) {
    axes.push_back(a.X_WC.linear().col(i));
    axes.push_back(b.X_WC.linear().col(i));
    for (int j = 0; j < 3; ++j)
      axes.push_back(a.X_WC.linear().col(i).cross(b.X_WC.linear().col(j)));
  }
  return axes;
}

}  // namespace

double box_depth(const OracleBox& a, const OracleBox& b) {
  return least_overlap(a, b, pose_axes(a, b), Vec3::Zero());
}

double swept_box_depth(const OracleBox& a, const Vec3& d, const OracleBox& b) {
  std::vector<Vec3> axes = pose_axes(a, b);
  for (int i = 0; i < 3; ++i) {
    axes.push_back(d.cross(a.X_WC.linear().col(i)));
    axes.push_back(d.cross(b.X_WC.linear().col(i)));
  }
  return least_overlap(a, b, axes, d);
}

Truth classify(const std::function<double(double)>& depth, double speed, double tolerance,
               double band) {
  struct Interval {
    double s0, s1;
  };
  std::vector<Interval> open = {{0, 1}};
  if (depth(0) > tolerance + band || depth(1) > tolerance + band) return Truth::kHit;
  bool near = false;
  while (!open.empty()) {
    const Interval interval = open.back();
    open.pop_back();
    const double middle = 0.5 * (interval.s0 + interval.s1);
    const double half = 0.5 * (interval.s1 - interval.s0);
    const double here = depth(middle);
    if (here > tolerance + band) return Truth::kHit;
    if (here + speed * half <= tolerance - band) continue;
    if (speed * half < 0.1 * band) {
      near = true;
      continue;
    }
    open.push_back({interval.s0, middle});
    open.push_back({middle, interval.s1});
  }
  return near ? Truth::kNearBoundary : Truth::kFree;
}

}  // namespace rubicon::collision::test
