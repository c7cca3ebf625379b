#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "src/collision/body_pair.hpp"
#include "src/collision/swept_query.hpp"

namespace rubicon::collision {
namespace {

void require_tolerance(double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance)) {
    throw std::invalid_argument(
        fmt::format("the contact tolerance is {}, expected 0 m or more", tolerance));
  }
}

struct Obstacle {
  ObstacleId id = 0;
  BodyPtr body;
  Pose X_WB;
};

std::vector<ObstacleId> sorted(std::vector<ObstacleId> ids) {
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace

/// A list scanned in the order of ids, boxes apart from the rest so that the scan stays in the
/// cache.
struct CollisionWorld::Impl {
  std::vector<Bounds> boxes;
  std::vector<Obstacle> obstacles;  ///< ids ascending
  ObstacleId next_id = 1;

  /// The first obstacle, by id, that `body` meets on its way.
  std::optional<ObstacleId> first_met(const Body& body, const Motion& motion, double tolerance,
                                      const std::vector<ObstacleId>& sorted_ignored) const {
    const Bounds swept = swept_bounds(body, motion);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (swept.disjoint(boxes[i])) continue;
      const Obstacle& obstacle = obstacles[i];
      if (std::binary_search(sorted_ignored.begin(), sorted_ignored.end(), obstacle.id)) continue;
      if (bodies_blocked(body, motion, *obstacle.body, geometry::stationary(obstacle.X_WB),
                         tolerance)) {
        return obstacle.id;
      }
    }
    return std::nullopt;
  }
};

CollisionWorld::CollisionWorld() : impl_(std::make_unique<Impl>()) {}
CollisionWorld::~CollisionWorld() = default;
CollisionWorld::CollisionWorld(CollisionWorld&&) noexcept = default;
CollisionWorld& CollisionWorld::operator=(CollisionWorld&&) noexcept = default;

ObstacleId CollisionWorld::insert(BodyPtr body, const Pose& X_WB) {
  if (!body) throw std::invalid_argument("an obstacle needs a body");
  require_rigid(X_WB, "the pose of an obstacle");
  impl_->boxes.push_back(swept_bounds(*body, geometry::stationary(X_WB)));
  impl_->obstacles.push_back({impl_->next_id, std::move(body), X_WB});
  return impl_->next_id++;
}

void CollisionWorld::remove(ObstacleId id) {
  auto& obstacles = impl_->obstacles;
  const auto found = std::lower_bound(
      obstacles.begin(), obstacles.end(), id,
      [](const Obstacle& obstacle, ObstacleId value) { return obstacle.id < value; });
  if (found == obstacles.end() || found->id != id) {
    throw std::invalid_argument(fmt::format("there is no obstacle {}", id));
  }
  impl_->boxes.erase(impl_->boxes.begin() + (found - obstacles.begin()));
  obstacles.erase(found);
}

SweptResult CollisionWorld::test(const SweptQuery& query) const {
  require_tolerance(query.contact_tolerance);
  const int count = static_cast<int>(query.items.size());
  for (const SweptQuery::Item& item : query.items) {
    if (item.moving.body == nullptr) throw std::invalid_argument("a moving item needs a body");
  }
  for (const auto& [first, second] : query.pairs) {
    if (first < 0 || second < 0 || first >= count || second >= count || first == second) {
      throw std::invalid_argument(fmt::format(
          "the pair ({}, {}) does not name two of the {} moving bodies", first, second, count));
    }
  }
  const std::vector<ObstacleId> ignored = sorted(query.ignore);
  for (int i = 0; i < count; ++i) {
    const SweptQuery::Item& item = query.items[i];
    if (!item.against_world) continue;
    const std::optional<ObstacleId> met =
        impl_->first_met(*item.moving.body, item.moving.motion, query.contact_tolerance, ignored);
    if (met) return {SweptHit{i, met, std::nullopt}};
  }
  for (const auto& [first, second] : query.pairs) {
    const MovingBody& a = query.items[first].moving;
    const MovingBody& b = query.items[second].moving;
    if (bodies_blocked(*a.body, a.motion, *b.body, b.motion, query.contact_tolerance)) {
      return {SweptHit{first, std::nullopt, second}};
    }
  }
  return {};
}

std::optional<ObstacleId> CollisionWorld::blocked_at(const Body& body, const Pose& X_WB,
                                                     double contact_tolerance,
                                                     const std::vector<ObstacleId>& ignore) const {
  require_tolerance(contact_tolerance);
  return impl_->first_met(body, geometry::stationary(X_WB), contact_tolerance, sorted(ignore));
}

bool overlaps(const Body& a, const Pose& X_WA, const Body& b, const Pose& X_WB,
              double contact_tolerance) {
  require_tolerance(contact_tolerance);
  return bodies_blocked(a, geometry::stationary(X_WA), b, geometry::stationary(X_WB),
                        contact_tolerance);
}

}  // namespace rubicon::collision
