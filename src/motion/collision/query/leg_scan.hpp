#pragma once

#include <functional>
#include <vector>

#include "src/motion/collision/base/bounds.hpp"
#include "src/motion/collision/leg_query.hpp"
#include "src/motion/collision/sweep/body.hpp"

namespace rubicon::collision {

/// One that stands and may be met.
struct ScannedObstacle {
  ObstacleId id = 0;
  const Body* body = nullptr;
  const Placement* X_WC = nullptr;
};

/// Answers a query about a leg by halving it. At the middle of an interval no point is farther from
/// where it is in the rest of it than half of the interval times its speed: pairs of boxes that are
/// farther apart than that are done with for the whole interval, and only the others are looked at
/// in its halves. Boxes around parts decide what is free; what is met is only known of parts that
/// are boxes. What stays open in short intervals goes to the exact test. docs/collision.md, Legs.
class LegScan {
 public:
  using Collect = std::function<void(const Bounds&, std::vector<ScannedObstacle>&)>;

  LegScan(const LegQuery& query, const LegMotion& motion, const Collect& collect);
  LegAnswer run();

 private:
  /// A box around a part of a body, world.
  struct PartBox {
    OrientedBox box;
    Vec3 half_W = Vec3::Zero();  ///< m, of the box around it along the axes of the world
    bool exact = false;          ///< the part is this box
  };
  /// A part of an item against one of an obstacle, or of another item.
  struct Candidate {
    int item = 0;
    int part = 0;   ///< index into the boxes of all items
    int other = 0;  ///< index into the boxes of obstacles, or of all items
    int met = 0;    ///< index into the obstacles, or the other item
    bool own = false;
    double speed = 0;  ///< of an own pair
  };

  /// Where the items' centred coordinates are.
  using ItemPlaces = std::vector<Placement>;

  void collect_obstacles(const ItemPlaces& middle);
  void add_pairs();
  void find_places(double share, ItemPlaces& places);
  void place_items(const ItemPlaces& places);
  void find_ways(const ItemPlaces& from, const ItemPlaces& middle, const ItemPlaces& to,
                 double half);
  void place(const Body& body, const Placement& X_WC, std::vector<PartBox>& boxes, std::size_t at);
  bool scan(double from, double to, const ItemPlaces& at_from, const ItemPlaces& at_to,
            std::size_t begin, std::size_t end, int depth, bool met_at_end);
  bool is_answered() const;

  const LegQuery& query_;
  const LegMotion& motion_;
  const Collect& collect_;
  LegAnswer answer_;
  std::vector<Pose> X_WB_;
  std::vector<ItemPlaces> middles_;  ///< of the intervals that are looked at, by their depth
  std::vector<double> ways_;  ///< m: no point of an item is farther from where it is in the middle
  std::vector<PartBox> items_;          ///< at the share looked at last
  std::vector<std::size_t> first_box_;  ///< of each item
  std::vector<PartBox> standing_;
  std::vector<ObstacleId> obstacle_ids_;
  std::vector<Candidate> candidates_;  ///< a stack: those of an interval after those of its parent
  int exact_tests_ = 0;
  double fastest_ = 0;  ///< m: the greatest speed of a candidate
};

}  // namespace rubicon::collision
