#include "src/motion/collision/convex/swept_pair.hpp"

#include <algorithm>

namespace rubicon::collision {
namespace {

Interval swept_extent(const SweptPair& pair, const Vec3& n) {
  Interval swept = pair.moving.extent(pair.start.R.transpose() * n);
  const double at_start = n.dot(pair.start.t);
  swept.least += at_start;
  swept.greatest += at_start;
  if (pair.standing) return swept;
  const Interval last = pair.moving.extent(pair.end.R.transpose() * n);
  const double at_end = n.dot(pair.end.t);
  const double growth = pair.growth(n);
  return {std::min(swept.least, last.least + at_end) - growth,
          std::max(swept.greatest, last.greatest + at_end) + growth};
}

}  // namespace

double SweptPair::growth(const Vec3& n) const {
  if (standing) return 0;
  double result = uniform_growth;
  if (axial_growth > 0) result += axial_growth * (n - n.dot(growth_axis) * growth_axis).norm();
  return result;
}

double SweptPair::overlap(const Vec3& n) const {
  return swept_extent(*this, n).greatest - fixed.extent(n).least;
}

bool SweptPair::free_along(const Vec3& n) const {
  const Interval swept = swept_extent(*this, n);
  const Interval still = fixed.extent(n);
  return swept.greatest - still.least <= tolerance || still.greatest - swept.least <= tolerance;
}

SweptPair::Support SweptPair::support(const Vec3& n) const {
  const Vec3 opposite = fixed.core_support(-n);
  const Vec3 first = start * moving.core_support(start.R.transpose() * n);
  if (standing) return {first, opposite};
  const Vec3 last = end * moving.core_support(end.R.transpose() * n);
  return {n.dot(first) >= n.dot(last) ? first : last, opposite};
}

Vec3 SweptPair::difference_support(const Vec3& n) const {
  const Support both = support(n);
  return both.moving - both.fixed;
}

}  // namespace rubicon::collision
