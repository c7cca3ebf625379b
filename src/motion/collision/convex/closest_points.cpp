#include "src/motion/collision/convex/closest_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "src/motion/collision/convex/gjk.hpp"

namespace rubicon::collision {
namespace {

/// The bounds agree to this (m): nothing more can be gained.
constexpr double kClosestConverged = 1e-9;
/// Subtracted from certified distances (m): more than their rounding.
constexpr double kDistanceRounding = 1e-12;
constexpr int kMaxClosestRounds = 128;

/// The corners of a simplex with the points they are the differences of.
struct TwoSidedSimplex {
  Simplex differences;
  std::array<SweptPair::Support, 4> sides;

  void add(const SweptPair::Support& support) {
    differences.points[differences.size] = support.moving - support.fixed;
    sides[differences.size] = support;
    ++differences.size;
  }
};

/// Barycentric coordinates of `point`, which lies in the hull of the first `count` corners (or is
/// the nearest there is).
std::array<double, 4> weights_of(const std::array<Vec3, 4>& corners, int count, const Vec3& point) {
  std::array<double, 4> weights{1, 0, 0, 0};
  if (count == 2) {
    const Vec3 edge = corners[1] - corners[0];
    const double squared = edge.squaredNorm();
    weights[1] = squared > 0 ? std::clamp((point - corners[0]).dot(edge) / squared, 0.0, 1.0) : 0;
    weights[0] = 1 - weights[1];
  } else if (count == 3) {
    const Vec3 ab = corners[1] - corners[0];
    const Vec3 ac = corners[2] - corners[0];
    const Vec3 normal = ab.cross(ac);
    const double squared = normal.squaredNorm();
    const Vec3 arm = point - corners[0];
    if (squared > 0) {
      weights[1] = normal.dot(arm.cross(ac)) / squared;
      weights[2] = normal.dot(ab.cross(arm)) / squared;
    }
  } else if (count == 4) {
    const Vec3 a = corners[1] - corners[0];
    const Vec3 b = corners[2] - corners[0];
    const Vec3 c = corners[3] - corners[0];
    const double volume = a.dot(b.cross(c));
    const Vec3 arm = point - corners[0];
    if (volume != 0) {
      weights[1] = arm.dot(b.cross(c)) / volume;
      weights[2] = a.dot(arm.cross(c)) / volume;
      weights[3] = a.dot(b.cross(arm)) / volume;
    }
  }
  double sum = 0;
  for (int i = 1; i < count; ++i) {
    weights[i] = std::clamp(weights[i], 0.0, 1.0);
    sum += weights[i];
  }
  if (sum > 1) {
    for (int i = 1; i < count; ++i) weights[i] /= sum;
    sum = 1;
  }
  weights[0] = 1 - sum;
  return weights;
}

/// The points of both sides that belong to `point` of the difference.
SweptPair::Support sides_of(const TwoSidedSimplex& simplex, const std::array<int, 4>& kept,
                            int count, const Vec3& point) {
  std::array<Vec3, 4> corners;
  for (int i = 0; i < count; ++i) corners[i] = simplex.differences.points[kept[i]];
  const std::array<double, 4> weights = weights_of(corners, count, point);
  SweptPair::Support result;
  for (int i = 0; i < count; ++i) {
    result.moving += weights[i] * simplex.sides[kept[i]].moving;
    result.fixed += weights[i] * simplex.sides[kept[i]].fixed;
  }
  return result;
}

/// From the cores' closest points to those of the solids with their balls.
ClosestPoints with_balls(const SweptPair& pair, const SweptPair::Support& cores,
                         double lower_bound) {
  ClosestPoints result;
  const Vec3 between = cores.moving - cores.fixed;
  const double distance = between.norm();
  result.lower_bound = std::max(0.0, lower_bound);
  if (distance > pair.balls() && distance > kTouching) {
    const Vec3 direction = between / distance;
    result.moving = cores.moving - direction * pair.moving.ball;
    result.fixed = cores.fixed + direction * pair.fixed.ball;
    result.upper_bound = distance - pair.balls();
    return result;
  }
  // Along the line between the cores each ball covers a stretch; the middle of the common one.
  const double from = std::max(0.0, distance - pair.moving.ball);
  const double to = std::min(distance, pair.fixed.ball);
  const double share = distance > 0 ? 0.5 * (from + to) / distance : 0.5;
  result.moving = cores.fixed + std::clamp(share, 0.0, 1.0) * between;
  result.fixed = result.moving;
  result.lower_bound = 0;
  return result;
}

}  // namespace

ClosestPoints closest_points(const SweptPair& pair) {
  Vec3 first = pair.middle * pair.moving.bounds.centre() - pair.fixed.bounds.centre();
  if (first.squaredNorm() == 0) first = Vec3::UnitX();
  TwoSidedSimplex simplex;
  simplex.add(pair.support(-first.normalized()));
  Vec3 nearest = simplex.differences.points[0];
  SweptPair::Support sides = simplex.sides[0];
  double lower = 0;
  for (int round = 0; round < kMaxClosestRounds; ++round) {
    const double distance = nearest.norm();
    if (distance < kTouching) return with_balls(pair, sides, 0);
    const Vec3 direction = -nearest / distance;
    const SweptPair::Support support = pair.support(direction);
    const double reach = direction.dot(support.moving - support.fixed);
    lower = std::max(lower, -reach - pair.balls() - pair.growth(direction) - kDistanceRounding);
    if (distance + reach <= kClosestConverged) break;
    const Vec3 difference = support.moving - support.fixed;
    const auto& points = simplex.differences.points;
    const bool known = std::any_of(points.begin(), points.begin() + simplex.differences.size,
                                   [&](const Vec3& own) { return own == difference; });
    if (known) break;
    simplex.add(support);
    if (simplex.differences.size == 4 && encloses_origin(simplex.differences)) {
      return with_balls(pair, sides_of(simplex, {0, 1, 2, 3}, 4, Vec3::Zero()), 0);
    }
    const Closest closest = closest_to_origin(simplex.differences);
    if (closest.distance_squared >= nearest.squaredNorm()) break;  // rounding: no progress
    nearest = closest.point;
    sides = sides_of(simplex, closest.kept, closest.size, nearest);
    TwoSidedSimplex reduced;
    for (int i = 0; i < closest.size; ++i) reduced.add(simplex.sides[closest.kept[i]]);
    simplex = reduced;
  }
  return with_balls(pair, sides, lower);
}

}  // namespace rubicon::collision
