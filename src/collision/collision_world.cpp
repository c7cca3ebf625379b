#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "src/collision/body_pair.hpp"
#include "src/collision/containment.hpp"
#include "src/collision/quick_test.hpp"
#include "src/collision/swept_query.hpp"
#include "src/collision/wide_tree.hpp"

namespace rubicon::collision {
namespace {

void require_tolerance(double tolerance) {
  if (!(tolerance >= 0) || !std::isfinite(tolerance)) {
    throw std::invalid_argument(
        fmt::format("the contact tolerance is {}, expected 0 m or more", tolerance));
  }
}

struct Obstacle {
  ObstacleId id = 0;  ///< 0: the place is free
  BodyPtr body;
  Pose X_WB;
  Placement X_WC;  ///< of the body's centred coordinates
};

}  // namespace

struct CollisionWorld::Impl {
  std::vector<Obstacle> obstacles;
  std::vector<int> free_places;
  std::unordered_map<ObstacleId, int> place_of;
  WideTree tree;  ///< over the places in `obstacles`
  ObstacleId next_id = 1;

  /// The obstacles whose boxes meet the sweep, those to be ignored left out, by ascending id.
  void collect(const Sweep& sweep, const std::vector<ObstacleId>& ignore, ItemList& found) const {
    tree.collect(sweep.bounds(), found);
    const auto ignored = [&](int place) {
      return std::find(ignore.begin(), ignore.end(), obstacles[place].id) != ignore.end();
    };
    if (!ignore.empty()) {
      found.set_size(
          static_cast<int>(std::remove_if(found.begin(), found.end(), ignored) - found.begin()));
    }
    std::sort(found.begin(), found.end(),
              [this](int a, int b) { return obstacles[a].id < obstacles[b].id; });
  }

  bool blocks(const Obstacle& obstacle, Sweep& sweep, double tolerance) const {
    const Body& body = sweep.body();
    const Verdict found = quick_verdict(sweep, *obstacle.body, obstacle.X_WC, tolerance);
    if (found == Verdict::kHit) return true;
    if (found == Verdict::kUndecided) {
      return bodies_blocked(body, sweep.motion(), *obstacle.body,
                            geometry::stationary(obstacle.X_WB), tolerance);
    }
    return contained_on_the_way(sweep, obstacle, tolerance);
  }

  /// From outside a closed mesh one must cross its surface, so the ends of the step are enough.
  bool contained_on_the_way(Sweep& sweep, const Obstacle& obstacle, double tolerance) const {
    const Body& body = sweep.body();
    if (!body.has_closed_soup() && !obstacle.body->has_closed_soup()) return false;
    const auto contained_at = [&](const Placement& X_WC) {
      const Mat3 to_obstacle = obstacle.X_WC.R.transpose();
      const Placement seen(to_obstacle * X_WC.R, to_obstacle * (X_WC.t - obstacle.X_WC.t));
      return contained(body, *obstacle.body, seen, tolerance);
    };
    return contained_at(sweep.slice(0).start()) ||
           (sweep.moves() && contained_at(sweep.slice(sweep.slice_count() - 1).end()));
  }

  /// The first obstacle, by id, that `body` meets on its way.
  std::optional<ObstacleId> first_met(const Body& body, const Motion& motion, double tolerance,
                                      const std::vector<ObstacleId>& ignore) const {
    Sweep sweep(body, motion);
    ItemList candidates;
    collect(sweep, ignore, candidates);
    for (const int place : candidates) {
      if (blocks(obstacles[place], sweep, tolerance)) return obstacles[place].id;
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
  const Placement X_WC(X_WB.linear(), X_WB * body->extent().centre);
  const Bounds bounds = placed(body->bounds(), X_WC);
  int place = static_cast<int>(impl_->obstacles.size());
  if (impl_->free_places.empty()) {
    impl_->obstacles.emplace_back();
  } else {
    place = impl_->free_places.back();
    impl_->free_places.pop_back();
  }
  const ObstacleId id = impl_->next_id++;
  impl_->obstacles[place] = {id, std::move(body), X_WB, X_WC};
  impl_->place_of[id] = place;
  impl_->tree.insert(place, bounds);
  return id;
}

void CollisionWorld::remove(ObstacleId id) {
  const auto found = impl_->place_of.find(id);
  if (found == impl_->place_of.end()) {
    throw std::invalid_argument(fmt::format("there is no obstacle {}", id));
  }
  const int place = found->second;
  impl_->tree.remove(place);
  impl_->obstacles[place] = {};
  impl_->free_places.push_back(place);
  impl_->place_of.erase(found);
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
  for (int i = 0; i < count; ++i) {
    const SweptQuery::Item& item = query.items[i];
    if (!item.against_world) continue;
    const std::optional<ObstacleId> met = impl_->first_met(*item.moving.body, item.moving.motion,
                                                           query.contact_tolerance, query.ignore);
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
  return impl_->first_met(body, geometry::stationary(X_WB), contact_tolerance, ignore);
}

bool overlaps(const Body& a, const Pose& X_WA, const Body& b, const Pose& X_WB,
              double contact_tolerance) {
  require_tolerance(contact_tolerance);
  return bodies_blocked(a, geometry::stationary(X_WA), b, geometry::stationary(X_WB),
                        contact_tolerance);
}

}  // namespace rubicon::collision
