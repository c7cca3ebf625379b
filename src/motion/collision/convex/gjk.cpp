#include "src/motion/collision/convex/gjk.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace rubicon::collision {
namespace {

/// The lower and upper bound of the distance agree to this (m): nothing more can be gained.
constexpr double kGjkConverged = 1e-11;
/// A search that rounding stops nearer than this (m) is finished by the expanding polytope.
constexpr double kNearlyTouching = 1e-6;
/// Polytopes end after a few rounds; round shapes gain a constant factor a round.
constexpr int kMaxGjkRounds = 128;

void offer(Closest& best, const Vec3& point, std::initializer_list<int> kept) {
  const double distance_squared = point.squaredNorm();
  if (distance_squared >= best.distance_squared) return;
  best.point = point;
  best.distance_squared = distance_squared;
  best.size = 0;
  for (const int index : kept) best.kept[best.size++] = index;
}

void offer_edge(Closest& best, const Simplex& simplex, int i, int j) {
  const Vec3& a = simplex.points[i];
  const Vec3 edge = simplex.points[j] - a;
  const double length_squared = edge.squaredNorm();
  if (length_squared == 0) return;
  const double share = -a.dot(edge) / length_squared;
  if (share > 0 && share < 1) offer(best, a + share * edge, {i, j});
}

void offer_face(Closest& best, const Simplex& simplex, int i, int j, int k) {
  const Vec3& a = simplex.points[i];
  const Vec3 ab = simplex.points[j] - a;
  const Vec3 ac = simplex.points[k] - a;
  const Vec3 normal = ab.cross(ac);
  const double area_squared = normal.squaredNorm();
  if (area_squared == 0) return;
  // Barycentric coordinates of the origin's projection.
  const double share_b = normal.dot((-a).cross(ac)) / area_squared;
  const double share_c = normal.dot(ab.cross(-a)) / area_squared;
  if (share_b <= 0 || share_c <= 0 || share_b + share_c >= 1) return;
  offer(best, normal * (normal.dot(a) / area_squared), {i, j, k});
}

bool holds(const Simplex& simplex, const Vec3& point) {
  return std::any_of(simplex.points.begin(), simplex.points.begin() + simplex.size,
                     [&](const Vec3& own) { return own == point; });
}

}  // namespace

bool encloses_origin(const Simplex& simplex) {
  for (int i = 0; i < 4; ++i) {
    const Vec3& a = simplex.points[(i + 1) % 4];
    const Vec3 normal = (simplex.points[(i + 2) % 4] - a).cross(simplex.points[(i + 3) % 4] - a);
    const double apex_side = normal.dot(simplex.points[i] - a);
    const double origin_side = -normal.dot(a);
    if (apex_side == 0 || apex_side * origin_side < 0) return false;
  }
  return true;
}

Closest closest_to_origin(const Simplex& simplex) {
  Closest best;
  const int size = simplex.size;
  for (int i = 0; i < size; ++i) offer(best, simplex.points[i], {i});
  for (int i = 0; i < size; ++i) {
    for (int j = i + 1; j < size; ++j) offer_edge(best, simplex, i, j);
  }
  for (int i = 0; i < size; ++i) {
    for (int j = i + 1; j < size; ++j) {
      for (int k = j + 1; k < size; ++k) offer_face(best, simplex, i, j, k);
    }
  }
  return best;
}

GjkResult gjk(const SweptPair& pair) {
  GjkResult result;
  Simplex& simplex = result.simplex;
  Vec3 first = pair.middle * pair.moving.bounds.centre() - pair.fixed.bounds.centre();
  if (first.squaredNorm() == 0) first = Vec3::UnitX();
  simplex.points[0] = pair.difference_support(-first.normalized());
  simplex.size = 1;
  Vec3 nearest = simplex.points[0];
  for (int round = 0; round < kMaxGjkRounds; ++round) {
    const double distance = nearest.norm();
    if (distance < kTouching) {
      result.cores_meet = true;
      return result;
    }
    const Vec3 direction = -nearest / distance;
    const Vec3 support = pair.difference_support(direction);
    const double reach = direction.dot(support);
    if (reach + pair.balls() + pair.growth(direction) <= pair.tolerance) {
      result.free = true;
      return result;
    }
    if (distance + reach <= kGjkConverged) return result;
    result.cores_meet = distance < kNearlyTouching;  // the answer if the search can go no further
    if (holds(simplex, support)) return result;
    simplex.points[simplex.size++] = support;
    if (simplex.size == 4 && encloses_origin(simplex)) {
      result.cores_meet = true;
      return result;
    }
    const Closest closest = closest_to_origin(simplex);
    if (closest.distance_squared >= nearest.squaredNorm()) return result;  // rounding: no progress
    nearest = closest.point;
    Simplex reduced;
    for (int i = 0; i < closest.size; ++i) reduced.points[i] = simplex.points[closest.kept[i]];
    reduced.size = closest.size;
    simplex = reduced;
  }
  return result;
}

}  // namespace rubicon::collision
