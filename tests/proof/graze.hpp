#pragma once

#include <algorithm>
#include <cmath>

#include "tests/proof/case.hpp"

namespace rubicon::collision::proof {

/// One in so many cases of a solid is brought to the very boundary.
inline constexpr int kGrazeEvery = 4;

/// An offset of an obstacle at which a step only just hits or only just does not: bisection between
/// a free and a blocked place on a line that leads `towards` the mover or in a random direction,
/// down to `finest` m. `truth_at(offset)` is asked some twenty times. Zero offset if the line never
/// changes from one to the other.
template <typename TruthAt>
Vec3 grazing_offset(Random& random, const Vec3& towards, double finest, const TruthAt& truth_at) {
  const Truth first = truth_at(Vec3::Zero());
  if (first == Truth::kNearBoundary) return Vec3::Zero();
  const bool blocked = first == Truth::kHit;
  const Vec3 direction = blocked ? random.direction() : towards.normalized();
  if (!(direction.norm() > 0.5)) return Vec3::Zero();
  double same = 0;  // where the truth is as at the start
  double other = blocked ? 0.1 : std::min(0.1, towards.norm());
  for (int i = 0; truth_at(other * direction) == first; ++i) {
    if (i == 6) return Vec3::Zero();
    same = other;
    other *= 2;
  }
  while (std::fabs(other - same) > finest) {
    const double middle = 0.5 * (same + other);
    const Truth truth = truth_at(middle * direction);
    // Within the band either end may close in; the answers stay on both sides of it.
    if (truth == Truth::kNearBoundary) {
      const Truth nearer = truth_at((0.75 * same + 0.25 * other) * direction);
      if (nearer == Truth::kNearBoundary) break;
      (nearer == first ? same : other) = 0.75 * same + 0.25 * other;
      continue;
    }
    (truth == first ? same : other) = middle;
  }
  return (random.below(2) ? same : other) * direction;
}

}  // namespace rubicon::collision::proof
