#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "src/motion/travel/exact.hpp"

namespace rubicon::travel {

/// The corners of a simple polygon, counter-clockwise: its interior is left of its edges.
using Ring = std::vector<LatticePoint>;

/// A ring through corners in metres, in either sense. Corners that fall together and corners on the
/// line of their neighbours are left out. Throws std::invalid_argument where fewer than three
/// corners remain or edges meet that are not neighbours.
Ring ring_of(std::span<const Vec2> corners);

/// The corners of a ring in metres, without error.
std::vector<Vec2> in_metres(const Ring& ring);

/// What encloses a ring, its border included, in pitches.
struct Box {
  std::int64_t low_x = 0, low_y = 0, high_x = 0, high_y = 0;

  bool meets(const Box& other) const {
    return low_x <= other.high_x && other.low_x <= high_x && low_y <= other.high_y &&
           other.low_y <= high_y;
  }
  void include(const Box& other);
};
Box box_of(const LatticePoint& a, const LatticePoint& b);
Box box_of(const Ring& ring);

/// The edge from corner `i` to the next.
inline const LatticePoint& next_corner(const Ring& ring, std::size_t i) {
  return ring[i + 1 < ring.size() ? i + 1 : 0];
}

bool is_convex(const Ring& ring);
/// m; how far a ring may at most move at once and still meet whatever it runs over: the least width
/// of a convex one, else the least distance between edges that are not neighbours.
double thickness(const Ring& ring);

/// A point that lies on an edge of each of two rings.
struct Meeting {
  int edge_a = 0;
  int edge_b = 0;
  ExactPoint at;
};

/// Where the borders of two rings meet: each crossing, each corner of one on an edge of the other,
/// each end of a stretch that they share. A point may come more than once, from different edges.
std::vector<Meeting> meetings(const Ring& a, const Ring& b);

}  // namespace rubicon::travel
