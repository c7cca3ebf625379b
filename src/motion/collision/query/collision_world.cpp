#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "src/motion/collision/pair/body_clearance.hpp"
#include "src/motion/collision/pair/body_contact.hpp"
#include "src/motion/collision/pair/body_pair.hpp"
#include "src/motion/collision/pair/fast_path.hpp"
#include "src/motion/collision/pair/standing_body.hpp"
#include "src/motion/collision/query/clearance_budget.hpp"
#include "src/motion/collision/query/leg_scan.hpp"
#include "src/motion/collision/swept_query.hpp"
#include "src/motion/collision/tree/wide_tree.hpp"
#include "src/motion/math/angles.hpp"

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
  StandingPlace place;
};

}  // namespace

struct CollisionWorld::Impl {
  std::vector<Obstacle> obstacles;
  std::vector<int> free_places;
  std::unordered_map<ObstacleId, int> place_of;
  WideTree tree;  ///< over the places in `obstacles`
  ObstacleId next_id = 1;
  WorldState state{std::make_shared<const int>(0), 0};

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

  /// Whether the body may come near any obstacle at all, by boxes that are sooner made than its
  /// sweep; false is certain. The motion must be valid.
  bool comes_near(const Body& body, const Motion& motion) const {
    const geometry::ScrewMotion* screw = screw_of(motion);
    if (screw == nullptr) return true;
    const Bounds& own = body.bounds();
    const Bounds& all = tree.around();
    const Vec3 centre = screw->X0 * (body.extent().centre + own.centre());
    const Vec3 half = screw->X0.linear().cwiseAbs() * own.half();
    // Written so that what is no number counts as near.
    const auto apart = [&](int i, double growth) {
      const double slide = screw->slide[i];
      return centre[i] - half[i] - growth + std::min(slide, 0.0) > all.upper[i] ||
             centre[i] + half[i] + growth + std::max(slide, 0.0) < all.lower[i];
    };
    if (screw->angle_deg == 0) return !(apart(2, 0) || apart(0, 0) || apart(1, 0));
    // No point goes farther than its arc, and none along the axis.
    double arc = -1;
    for (const int i : {2, 0, 1}) {
      const bool across = std::fabs(screw->axis[i]) != 1;
      if (across && arc < 0) {
        const Vec3 arm = screw->axis.cross(centre - screw->point).cwiseAbs();
        arc = math::radians(std::fabs(screw->angle_deg)) * (arm.sum() + own.half().sum());
      }
      if (apart(i, across ? arc : 0)) return false;
    }
    return true;
  }

  static bool blocks(const Obstacle& obstacle, Sweep& sweep, double tolerance) {
    return blocked_by_standing(sweep, *obstacle.body, obstacle.place, tolerance);
  }

  /// The first obstacle, by id, that the body meets on its way.
  std::optional<ObstacleId> first_met(Sweep& sweep, double tolerance,
                                      const std::vector<ObstacleId>& ignore) const {
    ItemList candidates;
    collect(sweep, ignore, candidates);
    for (const int place : candidates) {
      if (blocks(obstacles[place], sweep, tolerance)) return obstacles[place].id;
    }
    return std::nullopt;
  }

  SweptResult test(const SweptQuery& query, ClearanceBudget::Impl* budget) const;
  bool stays_far(const SweptQuery& query, int item, ClearanceBudget::Impl* budget) const;
  SweptResult test_near(const SweptQuery& query, ClearanceBudget::Impl* budget, int from) const;

  void insert(ObstacleId id, BodyPtr body, const Pose& X_WB) {
    if (!body) throw std::invalid_argument("an obstacle needs a body");
    require_rigid(X_WB, "the pose of an obstacle");
    const StandingPlace standing(*body, X_WB);
    const Bounds bounds = placed(body->bounds(), standing.X_WC);
    int free_place = static_cast<int>(obstacles.size());
    if (free_places.empty()) {
      obstacles.emplace_back();
    } else {
      free_place = free_places.back();
      free_places.pop_back();
    }
    obstacles[free_place] = {id, std::move(body), standing};
    place_of[id] = free_place;
    tree.insert(free_place, bounds);
    changed();
  }

  /// How far the box of an obstacle is from that of a sweep (m).
  double box_distance(const Sweep& sweep, const Obstacle& obstacle) const {
    const Bounds other = placed(obstacle.body->bounds(), obstacle.place.X_WC);
    const Bounds& own = sweep.bounds();
    return (other.lower - own.upper).cwiseMax(own.lower - other.upper).cwiseMax(0.0).norm();
  }

  /// The places of the obstacles that may be as near to the sweep as `range` (m): the nearest box
  /// first, of equals the lowest id.
  std::vector<int> nearest_first(const Sweep& sweep, double range,
                                 const std::vector<ObstacleId>& ignore) const {
    Bounds grown = sweep.bounds();
    grown.grow(Vec3::Constant(range));
    ItemList found;
    tree.collect(grown, found);
    struct Near {
      double distance;
      ObstacleId id;
      int place;
    };
    std::vector<Near> list;
    for (const int place : found) {
      const Obstacle& one = obstacles[place];
      if (std::find(ignore.begin(), ignore.end(), one.id) != ignore.end()) continue;
      list.push_back({box_distance(sweep, one), one.id, place});
    }
    std::sort(list.begin(), list.end(), [](const Near& a, const Near& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
    });
    std::vector<int> places;
    for (const Near& one : list) places.push_back(one.place);
    return places;
  }

  const Obstacle& obstacle(ObstacleId id) const {
    const auto found = place_of.find(id);
    if (found == place_of.end()) {
      throw std::invalid_argument(fmt::format("there is no obstacle {}", id));
    }
    return obstacles[found->second];
  }

  void changed() { ++state.changes; }
};

namespace {

void require_valid_query(const SweptQuery& query) {
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
}

/// The contact of two bodies that block each other. The fast path and the search for contact
/// round differently: a pair that is just as deep as the tolerance may seem free to the search,
/// which then asks for a little less.
Contact contact_of(const MovingBody& a, const MovingBody& b, double tolerance) {
  for (const double less : {0.0, 1e-9, 1e-8, 1e-7, 1e-6}) {
    const auto found =
        body_contact(*a.body, a.motion, *b.body, b.motion, std::max(tolerance - less, 0.0));
    if (found) return *found;
  }
  throw std::invalid_argument("the two bodies of the hit do not block each other");
}

/// The sweeps of a query's items, each made when first asked for.
class Sweeps {
 public:
  explicit Sweeps(const SweptQuery& query) : query_(query) {}

  Sweep& of(int item) {
    const MovingBody& moving = query_.items[item].moving;
    std::optional<Sweep>& sweep = place_of(item);
    if (!is_kept() || !sweep) sweep.emplace(*moving.body, moving.motion);
    return *sweep;
  }

  /// The first time that the item is asked for, if its motion was found to be valid.
  Sweep& of_valid(int item) {
    const MovingBody& moving = query_.items[item].moving;
    return place_of(item).emplace(*moving.body, moving.motion, Sweep::Valid{});
  }

 private:
  /// Most machines have fewer parts; their sweeps need no memory of their own.
  static constexpr int kFew = 12;

  /// Without pairs nobody comes back to an item.
  bool is_kept() const { return !query_.pairs.empty(); }

  std::optional<Sweep>& place_of(int item) { return is_kept() ? kept(item) : only_; }

  std::optional<Sweep>& kept(int item) {
    if (item < kFew) {
      if (!few_) few_.emplace();
      return (*few_)[item];
    }
    if (more_.empty()) more_.resize(query_.items.size() - kFew);
    return more_[item - kFew];
  }

  const SweptQuery& query_;
  std::optional<Sweep> only_;
  std::optional<std::array<std::optional<Sweep>, kFew>> few_;
  std::vector<std::optional<Sweep>> more_;
};

bool in_pair(const SweptQuery& query, int item) {
  return std::any_of(query.pairs.begin(), query.pairs.end(), [item](const auto& pair) {
    return pair.first == item || pair.second == item;
  });
}

/// Whether two bodies of a query block each other.
bool items_blocked(Sweep& a, Sweep& b, double tolerance) {
  if (a.bounds().disjoint(b.bounds())) return false;
  // One that stands is quickly seen to be out of the way.
  Sweep& moving = b.moves() ? b : a;
  Sweep& standing = b.moves() ? a : b;
  const bool has_inside = a.body().has_closed_soup() || b.body().has_closed_soup();
  if (!standing.moves() && !has_inside) {
    const Verdict found =
        fast_path_verdict(moving, standing.body(), standing.slice(0).start(), tolerance);
    if (found != Verdict::kUndecided) return found == Verdict::kHit;
  }
  return bodies_blocked(a.body(), a.motion(), b.body(), b.motion(), tolerance);
}

}  // namespace

CollisionWorld::CollisionWorld() : impl_(std::make_unique<Impl>()) {}
CollisionWorld::~CollisionWorld() = default;
CollisionWorld::CollisionWorld(CollisionWorld&&) noexcept = default;
CollisionWorld& CollisionWorld::operator=(CollisionWorld&&) noexcept = default;

ObstacleId CollisionWorld::insert(BodyPtr body, const Pose& X_WB) {
  impl_->insert(impl_->next_id, std::move(body), X_WB);
  return impl_->next_id++;
}

void CollisionWorld::put_back(ObstacleId id, BodyPtr body, const Pose& X_WB) {
  if (id == 0 || id >= impl_->next_id || impl_->place_of.contains(id)) {
    throw std::invalid_argument(fmt::format("there is no removed obstacle {}", id));
  }
  impl_->insert(id, std::move(body), X_WB);
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
  impl_->changed();
}

void CollisionWorld::replace(ObstacleId id, BodyPtr body, const Pose& X_WB) {
  const auto found = impl_->place_of.find(id);
  if (found == impl_->place_of.end()) {
    throw std::invalid_argument(fmt::format("there is no obstacle {}", id));
  }
  if (!body) throw std::invalid_argument("an obstacle needs a body");
  require_rigid(X_WB, "the pose of an obstacle");
  const StandingPlace standing(*body, X_WB);
  impl_->tree.replace(found->second, placed(body->bounds(), standing.X_WC));
  impl_->obstacles[found->second] = {id, std::move(body), standing};
  impl_->changed();
}

/// Whether the item is seen to be far from all obstacles without its sweep. Throws where its motion
/// is not valid.
bool CollisionWorld::Impl::stays_far(const SweptQuery& query, int item,
                                     ClearanceBudget::Impl* budget) const {
  const MovingBody& moving = query.items[item].moving;
  const geometry::ScrewMotion* screw = screw_of(moving.motion);
  const bool slides = budget != nullptr && screw != nullptr && screw->angle_deg == 0;
  if (slides && budget->covers_slide(item, *moving.body, *screw)) return true;
  require_valid(moving.motion);
  if (comes_near(*moving.body, moving.motion)) return false;
  if (slides) budget->measure_slide(item, *moving.body, moving.motion, tree);
  return true;
}

SweptResult CollisionWorld::Impl::test(const SweptQuery& query,
                                       ClearanceBudget::Impl* budget) const {
  require_valid_query(query);
  if (budget != nullptr) budget->look_at(state);
  // Most steps go far from everything: for them no room is made for sweeps.
  const bool pairs = !query.pairs.empty();
  const int count = static_cast<int>(query.items.size());
  for (int i = 0; i < count; ++i) {
    if (!query.items[i].against_world) continue;
    if (!stays_far(query, i, pairs && in_pair(query, i) ? nullptr : budget)) {
      return test_near(query, budget, i);
    }
  }
  return pairs ? test_near(query, budget, count) : SweptResult();
}

/// The same where the items before `from` stay far, and that one does not.
SweptResult CollisionWorld::Impl::test_near(const SweptQuery& query, ClearanceBudget::Impl* budget,
                                            int from) const {
  Sweeps sweeps(query);
  for (int i = from; i < static_cast<int>(query.items.size()); ++i) {
    const SweptQuery::Item& item = query.items[i];
    if (!item.against_world) continue;
    const Body& body = *item.moving.body;
    // Who is in a pair needs its sweep anyway, and with it the tree costs less than the budget.
    ClearanceBudget::Impl* use = budget != nullptr && !in_pair(query, i) ? budget : nullptr;
    if (i != from && stays_far(query, i, use)) continue;
    if (use != nullptr && use->covers(i, body, item.moving.motion)) continue;
    const std::optional<ObstacleId> met =
        first_met(sweeps.of_valid(i), query.contact_tolerance, query.ignore);
    if (met) return {SweptHit{i, met, std::nullopt}};
    if (use != nullptr) use->measure(i, body, item.moving.motion, tree);
  }
  for (const auto& [first, second] : query.pairs) {
    if (items_blocked(sweeps.of(first), sweeps.of(second), query.contact_tolerance)) {
      return {SweptHit{first, std::nullopt, second}};
    }
  }
  return {};
}

SweptResult CollisionWorld::test(const SweptQuery& query) const {
  return impl_->test(query, nullptr);
}

SweptResult CollisionWorld::test(const SweptQuery& query, ClearanceBudget& budget) const {
  return impl_->test(query, budget.impl_.get());
}

LegAnswer CollisionWorld::look_along(const LegQuery& query, const LegMotion& motion) const {
  require_tolerance(query.contact_tolerance);
  const LegScan::Collect collect = [&](const Bounds& bounds, std::vector<ScannedObstacle>& found) {
    ItemList places;
    impl_->tree.collect(bounds, places);
    std::sort(places.begin(), places.end(),
              [&](int a, int b) { return impl_->obstacles[a].id < impl_->obstacles[b].id; });
    for (const int place : places) {
      const Obstacle& each = impl_->obstacles[place];
      found.push_back({each.id, each.body.get(), &each.place.X_WC});
    }
  };
  // Thousands of looks are made for a way: they share the room.
  thread_local LegScanRoom room;
  return LegScan(query, motion, collect, room).run();
}

Contact CollisionWorld::contact(const SweptQuery& query, const SweptHit& hit) const {
  require_valid_query(query);
  const int count = static_cast<int>(query.items.size());
  if (hit.item < 0 || hit.item >= count || hit.obstacle.has_value() == hit.other_item.has_value() ||
      hit.other_item.value_or(0) < 0 || hit.other_item.value_or(0) >= count) {
    throw std::invalid_argument("the hit does not name two bodies of the query");
  }
  const MovingBody& moving = query.items[hit.item].moving;
  if (hit.obstacle) {
    const Obstacle& obstacle = impl_->obstacle(*hit.obstacle);
    return contact_of(moving, {obstacle.body.get(), geometry::stationary(obstacle.place.X_WB)},
                      query.contact_tolerance);
  }
  return contact_of(moving, query.items[*hit.other_item].moving, query.contact_tolerance);
}

std::vector<BlockingPair> CollisionWorld::explain(const SweptQuery& query) const {
  require_valid_query(query);
  std::vector<BlockingPair> result;
  const auto add = [&](const SweptHit& hit) { result.push_back({hit, contact(query, hit)}); };
  Sweeps sweeps(query);
  for (int i = 0; i < static_cast<int>(query.items.size()); ++i) {
    if (!query.items[i].against_world) continue;
    Sweep& sweep = sweeps.of(i);
    ItemList candidates;
    impl_->collect(sweep, query.ignore, candidates);
    for (const int place : candidates) {
      const Obstacle& obstacle = impl_->obstacles[place];
      if (impl_->blocks(obstacle, sweep, query.contact_tolerance)) {
        add({i, obstacle.id, std::nullopt});
      }
    }
  }
  for (const auto& [first, second] : query.pairs) {
    if (items_blocked(sweeps.of(first), sweeps.of(second), query.contact_tolerance)) {
      add({first, std::nullopt, second});
    }
  }
  return result;
}

Clearance CollisionWorld::clearance(const SweptQuery& query, double range,
                                    double resolution) const {
  require_valid_query(query);
  if (!(range >= 0) || !std::isfinite(range) || !(resolution > 0) || !std::isfinite(resolution)) {
    throw std::invalid_argument(
        fmt::format("a clearance needs a range of 0 m or more and a resolution above 0 m, "
                    "not {} and {}",
                    range, resolution));
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  NearestMiss nearest;
  nearest.range = range;
  nearest.resolution = resolution;
  nearest.certified = kInfinity;
  nearest.found = kInfinity;
  Clearance result;
  const auto look = [&](int item, const Body& other, const Motion& motion, const SweptHit& pair) {
    const MovingBody& moving = query.items[item].moving;
    if (!add_clearance(*moving.body, moving.motion, other, motion, query.contact_tolerance,
                       nearest)) {
      return;
    }
    result.pair = pair;
    result.fraction = nearest.fraction;
    result.point_moving_W = nearest.on_a_W;
    result.point_met_W = nearest.on_b_W;
  };
  Sweeps sweeps(query);
  for (int i = 0; i < static_cast<int>(query.items.size()); ++i) {
    if (!query.items[i].against_world) continue;
    const Sweep& sweep = sweeps.of(i);
    for (const int place : impl_->nearest_first(sweep, range, query.ignore)) {
      const Obstacle& obstacle = impl_->obstacles[place];
      if (impl_->box_distance(sweep, obstacle) > nearest.reach()) break;
      look(i, *obstacle.body, geometry::stationary(obstacle.place.X_WB),
           {i, obstacle.id, std::nullopt});
    }
  }
  for (const auto& [first, second] : query.pairs) {
    const MovingBody& other = query.items[second].moving;
    look(first, *other.body, other.motion, {first, std::nullopt, second});
  }
  // A distance beyond the range may have been met on the way; it is not part of the answer.
  if (nearest.found > range) {
    result = {};
    result.lower_bound = std::min(nearest.certified, range) < range ? nearest.certified : kInfinity;
    result.upper_bound = kInfinity;
    return result;
  }
  result.lower_bound = std::min(nearest.certified, nearest.found);
  result.upper_bound = nearest.found;
  return result;
}

std::optional<ObstacleId> CollisionWorld::blocked_at(const Body& body, const Pose& X_WB,
                                                     double contact_tolerance,
                                                     const std::vector<ObstacleId>& ignore) const {
  require_tolerance(contact_tolerance);
  const Motion standing = geometry::stationary(X_WB);
  Sweep sweep(body, standing);
  return impl_->first_met(sweep, contact_tolerance, ignore);
}

bool overlaps(const Body& a, const Pose& X_WA, const Body& b, const Pose& X_WB,
              double contact_tolerance) {
  require_tolerance(contact_tolerance);
  return bodies_blocked(a, geometry::stationary(X_WA), b, geometry::stationary(X_WB),
                        contact_tolerance);
}

}  // namespace rubicon::collision
