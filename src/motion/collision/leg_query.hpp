#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "src/motion/collision/swept_query.hpp"
#include "src/motion/math/lanes.hpp"

namespace rubicon::collision {

/// Asks how far bodies may go along a leg.
struct LegQuery {
  /// Bounds the second derivative by the share of the leg: of a point at the distance r from the
  /// origin of its frame, origin + turning * r.
  struct Acceleration {
    double origin = 0;   ///< m
    double turning = 0;  ///< m per m of distance
  };
  struct Item {
    const Body* body = nullptr;
    int frame = 0;      ///< which carries it
    bool moves = true;  ///< where not, it is not tested against what stands
    Acceleration acceleration = {};
  };
  /// Two items that may not meet, and a frame that carries both (-1: the world).
  struct Pair {
    int first = 0;
    int second = 0;
    int base = -1;
  };
  int frames = 0;
  std::vector<Item> items;
  std::vector<Pair> pairs;
  double contact_tolerance = 1e-3;
  /// What is asked. `whole`: whether the whole leg is free, no matter how far it is free else.
  /// Without it: the longest of the parts 1, 1/2, 1/4 ... of the leg that is free; shorter ones
  /// than `least` are of no use.
  bool whole = false;
  double least = 0;
};

/// A leg: bodies that move all at once along a way of any length, asked about by the share of it.
class LegMotion {
 public:
  virtual ~LegMotion() = default;
  /// Where all frames of the query are at four shares of the leg in [0, 1], and how they move.
  virtual void frames(const double (&shares)[math::kLanes], math::LaneFrame* X_WF) const = 0;
  /// Of the two items of a pair, as seen from its base; only asked for where they come near.
  virtual std::pair<LegQuery::Acceleration, LegQuery::Acceleration> seen_from_base(
      const LegQuery::Pair& pair) const = 0;
  /// Whether the piece between two shares is free, by `CollisionWorld::test`.
  virtual bool is_free(double from, double to) const = 0;
};

/// Shares of the leg. Between the two nothing is known.
struct LegAnswer {
  double free_until = 0;  ///< proved free from its beginning up to here
  /// From here on every longer part of the leg meets something, as `CollisionWorld::test` would
  /// say too; infinite: nothing is known to be met.
  double met_from = std::numeric_limits<double>::infinity();
  std::optional<SweptHit> hit;  ///< what is met there, where it was seen
};

}  // namespace rubicon::collision
