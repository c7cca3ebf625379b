#pragma once

#include <limits>

#include "src/motion/collision/base/placement.hpp"

namespace rubicon::collision {

/// An axis-parallel box in some frame (m); empty as constructed.
struct Bounds {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 upper = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  void add(const Bounds& other) {
    lower = lower.cwiseMin(other.lower);
    upper = upper.cwiseMax(other.upper);
  }
  void grow(const Vec3& by) {
    lower -= by;
    upper += by;
  }
  bool disjoint(const Bounds& other) const {
    return (lower.array() > other.upper.array()).any() ||
           (other.lower.array() > upper.array()).any();
  }
  bool contains(const Vec3& p) const {
    return (lower.array() <= p.array()).all() && (p.array() <= upper.array()).all();
  }
  Vec3 centre() const { return 0.5 * (lower + upper); }
  Vec3 half() const { return 0.5 * (upper - lower); }
};

/// The box around `bounds` after it is moved by `X`.
inline Bounds placed(const Bounds& bounds, const Placement& X) {
  const Vec3 centre = X * bounds.centre();
  const Vec3 half = X.R.cwiseAbs() * bounds.half();
  Bounds result;
  result.lower = centre - half;
  result.upper = centre + half;
  return result;
}

}  // namespace rubicon::collision
