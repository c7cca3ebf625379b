#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "src/motion/coverage/floor.hpp"

namespace rubicon::coverage {

/// A convex part of a shaft or column, and the same grown by the clearance. One parallel to the
/// axes is grown by the clearance in x and in y, others by an octagon round a circle of that
/// radius.
struct Obstacle {
  Ring grown;
  Box body;       ///< what encloses the part
  Box grown_box;  ///< what encloses it, grown
  bool is_box = false;
  int hole = 0;
};

/// A stretch of a line along x or y, low < high.
struct Stretch {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

/// Where the tool's own point may be: on the slab, borders included, not inside a grown obstacle.
/// What sees what is decided exactly. Keeps what it found, so it is for one thread at a time.
class FreeSpace {
 public:
  FreeSpace(const Floor& floor, double clearance);

  const std::vector<Obstacle>& obstacles() const { return obstacles_; }
  bool allows(const Point& p) const;
  /// Whether a place is inside no grown obstacle.
  bool is_clear(const Point& p) const;
  /// Whether the straight way between two allowed places is allowed.
  bool sees(const Point& a, const Point& b) const;
  /// The stretches of a line along x (along y) from a to b, which runs on the slab, that are in no
  /// obstacle.
  std::vector<Stretch> stretches_along_x(std::int64_t y, std::int64_t low, std::int64_t high) const;
  std::vector<Stretch> stretches_along_y(std::int64_t x, std::int64_t low, std::int64_t high) const;
  /// Calls `visit(obstacle)` for each obstacle whose grown box meets the box, some more than once.
  template <typename Visit>
  void for_each_near(const Box& box, const Visit& visit) const {
    obstacle_buckets_.any_in(box, [&](int item) {
      if (obstacles_[static_cast<std::size_t>(item)].grown_box.meets(box)) visit(item);
      return false;
    });
  }

  /// The shortest way between two allowed places, both included: Dijkstra with a straight-line
  /// bound on the visibility graph of the corners that lie in the ellipse of all ways of that
  /// length, which is widened until it is proved the shortest. Empty where there is none.
  std::vector<Point> shortest_way(const Point& a, const Point& b) const;
  /// Its length in units; infinite where there is none.
  double shortest_length(const Point& a, const Point& b) const;
  /// The same where it is `limit` or less; else anything more, found with less search.
  double shortest_length_within(const Point& a, const Point& b, double limit) const;
  /// Whether there is a way between two allowed places.
  bool reaches(const Point& a, const Point& b) const;

 private:
  class Flood;

  bool leaves_floor(const Point& a, const Point& b) const;
  bool nodes_see(int a, int b) const;
  /// The shortest way where it is no longer than `limit`, else none.
  std::vector<Point> way_within(const Point& a, const Point& b, double limit) const;
  /// The way of at most `bound` through corners; its length, infinite where none was found.
  double search(const Point& a, const Point& b, double bound, std::vector<Point>& way) const;

  Ring outline_;
  std::vector<Obstacle> obstacles_;
  std::vector<Point> nodes_;
  Buckets edge_buckets_;
  Buckets obstacle_buckets_;
  Buckets node_buckets_;
  double longest_ = 0;                     ///< units; no shortest way is longer
  mutable std::vector<signed char> seen_;  ///< of pairs of nodes: 0 not known yet, 1 yes, -1 no
};

}  // namespace rubicon::coverage
