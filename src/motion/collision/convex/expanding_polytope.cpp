#include "src/motion/collision/convex/expanding_polytope.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace rubicon::collision {
namespace {

/// A point counts as new when it is farther out than this (m).
constexpr double kProgress = 1e-11;
/// A difference set thinner than this (m) is flat.
constexpr double kFlatDifference = 1e-10;
/// Round shapes: the depth is known to about extent / rounds^1 near the end, far below a
/// millimetre.
constexpr int kMaxExpansions = 256;

struct Facet {
  std::array<int, 3> corners{};
  Vec3 normal = Vec3::Zero();  ///< unit, outwards
  double distance = 0;         ///< of its plane from the origin
  bool alive = true;
};

class Polytope {
 public:
  explicit Polytope(const SweptPair& pair) : pair_(pair) {}

  /// Extends `simplex` to a tetrahedron. False where the difference set is flat; `flat_free()` then
  /// has the answer.
  bool start(const Simplex& simplex);
  bool flat_free() const { return flat_free_; }
  bool expand_until_decided();

 private:
  Vec3 support(const Vec3& direction) const { return pair_.difference_support(direction); }
  bool add_farthest_along(const Vec3& direction);
  bool add_facet(int a, int b, int c);
  void add_point(const Vec3& point);

  const SweptPair& pair_;
  std::vector<Vec3> points_;
  std::vector<Facet> facets_;
  Vec3 inside_ = Vec3::Zero();
  bool flat_free_ = false;
};

Vec3 some_perpendicular(const Vec3& direction) {
  int smallest = 0;
  direction.cwiseAbs().minCoeff(&smallest);
  return direction.cross(Vec3::Unit(smallest)).normalized();
}

/// Adds the farther of the two extreme points along +-direction if it is off the flat through the
/// points so far.
bool Polytope::add_farthest_along(const Vec3& direction) {
  for (const Vec3& outward : {direction, Vec3(-direction)}) {
    const Vec3 candidate = support(outward);
    if (outward.dot(candidate - points_.front()) > kFlatDifference) {
      points_.push_back(candidate);
      return true;
    }
  }
  flat_free_ = flat_free_ || pair_.free_along(direction);
  return false;
}

bool Polytope::start(const Simplex& simplex) {
  points_.assign(simplex.points.begin(), simplex.points.begin() + simplex.size);
  if (points_.size() == 4) {
    const Vec3 normal = (points_[1] - points_[0]).cross(points_[2] - points_[0]);
    if (std::fabs(normal.dot(points_[3] - points_[0])) <= kFlatDifference * normal.norm())
      points_.pop_back();
  }
  if (points_.size() == 3) {
    const Vec3 edge = points_[1] - points_[0];
    if (edge.cross(points_[2] - points_[0]).norm() <= kFlatDifference * edge.norm())
      points_.pop_back();
  }
  if (points_.size() == 2 && (points_[1] - points_[0]).norm() <= kFlatDifference)
    points_.pop_back();
  if (points_.size() == 1) {
    const bool grown = add_farthest_along(Vec3::UnitX()) || add_farthest_along(Vec3::UnitY()) ||
                       add_farthest_along(Vec3::UnitZ());
    if (!grown) return false;
  }
  if (points_.size() == 2) {
    const Vec3 edge = (points_[1] - points_[0]).normalized();
    const Vec3 across = some_perpendicular(edge);
    if (!add_farthest_along(across) && !add_farthest_along(edge.cross(across))) return false;
  }
  if (points_.size() == 3) {
    const Vec3 normal = (points_[1] - points_[0]).cross(points_[2] - points_[0]).normalized();
    if (!add_farthest_along(normal)) return false;
  }
  inside_ = 0.25 * (points_[0] + points_[1] + points_[2] + points_[3]);
  return add_facet(0, 1, 2) && add_facet(0, 1, 3) && add_facet(0, 2, 3) && add_facet(1, 2, 3);
}

bool Polytope::add_facet(int a, int b, int c) {
  Facet facet;
  facet.corners = {a, b, c};
  const Vec3 normal = (points_[b] - points_[a]).cross(points_[c] - points_[a]);
  const double length = normal.norm();
  if (length == 0) return false;
  facet.normal = normal / length;
  facet.distance = facet.normal.dot(points_[a]);
  if (facet.normal.dot(inside_) > facet.distance) {
    std::swap(facet.corners[1], facet.corners[2]);
    facet.normal = -facet.normal;
    facet.distance = -facet.distance;
  }
  facets_.push_back(facet);
  return true;
}

/// Replaces the facets that see `point` by the cone from their horizon to it.
void Polytope::add_point(const Vec3& point) {
  const int apex = static_cast<int>(points_.size());
  points_.push_back(point);
  std::vector<std::pair<int, int>> horizon;
  for (Facet& facet : facets_) {
    if (!facet.alive || facet.normal.dot(point) - facet.distance <= 0) continue;
    facet.alive = false;
    for (int i = 0; i < 3; ++i) {
      const std::pair<int, int> edge{facet.corners[i], facet.corners[(i + 1) % 3]};
      bool shared = false;
      for (std::size_t k = 0; k < horizon.size(); ++k) {
        if (horizon[k].first != edge.second || horizon[k].second != edge.first) continue;
        horizon[k] = horizon.back();
        horizon.pop_back();
        shared = true;
        break;
      }
      if (!shared) horizon.push_back(edge);
    }
  }
  for (const auto& [from, to] : horizon) add_facet(from, to, apex);
}

bool Polytope::expand_until_decided() {
  for (int round = 0; round < kMaxExpansions; ++round) {
    const Facet* nearest = nullptr;
    for (const Facet& facet : facets_) {
      if (facet.alive && (nearest == nullptr || facet.distance < nearest->distance))
        nearest = &facet;
    }
    if (nearest == nullptr) return false;
    const Vec3 normal = nearest->normal;
    const double distance = nearest->distance;
    const Vec3 point = support(normal);
    const double reach = normal.dot(point);
    if (reach + pair_.balls() + pair_.growth(normal) <= pair_.tolerance) return true;
    if (distance + pair_.balls() > pair_.tolerance)
      return false;  // a ball of that radius is inside
    if (reach - distance <= kProgress) return false;
    add_point(point);
  }
  return false;
}

}  // namespace

bool shallow_direction_exists(const SweptPair& pair, const Simplex& simplex) {
  Polytope polytope(pair);
  if (!polytope.start(simplex)) return polytope.flat_free();
  return polytope.expand_until_decided();
}

}  // namespace rubicon::collision
