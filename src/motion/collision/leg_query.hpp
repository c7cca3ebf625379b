#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "src/motion/collision/swept_query.hpp"

namespace rubicon::collision {

/// A leg: bodies that move all at once along a way of any length, asked about by the share of it.
class LegMotion {
 public:
  virtual ~LegMotion() = default;
  /// Where the items of the query are at a share of the leg in [0, 1], world.
  virtual void poses(double share, std::vector<Pose>& X_WB) const = 0;
  /// Whether the piece between two shares is free, by `CollisionWorld::test`.
  virtual bool is_free(double from, double to) const = 0;
};

/// Asks how far bodies may go along a leg.
struct LegQuery {
  /// Bounds how far points go over the whole leg, by the length of their paths: of a point at the
  /// distance r from the origin of its body, origin + turning * r.
  struct Speed {
    double origin = 0;   ///< m
    double turning = 0;  ///< m per m of distance
  };
  struct Item {
    const Body* body = nullptr;
    Speed speed = {};
    /// The same for second derivatives by the share of the leg.
    Speed acceleration = {};
  };
  /// Two items that may not meet, and their speeds as seen from a frame that is the same for both.
  struct Pair {
    int first = 0;
    int second = 0;
    Speed of_first = {};
    Speed of_second = {};
  };
  std::vector<Item> items;  ///< each is tested against what stands, unless its speed is 0
  std::vector<Pair> pairs;
  double contact_tolerance = 1e-3;
  /// What is asked. `whole`: whether the whole leg is free, no matter how far it is free else.
  /// Without it: the longest of the parts 1, 1/2, 1/4 ... of the leg that is free; shorter ones
  /// than `least` are of no use.
  bool whole = false;
  double least = 0;
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
