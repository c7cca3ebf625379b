#include "src/motion/travel/ring.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace rubicon::travel {
namespace {

/// Whether c, which is on the line a b, is between a and b or one of them.
bool within(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  const Box box = box_of(a, b);
  return c.x >= box.low_x && c.x <= box.high_x && c.y >= box.low_y && c.y <= box.high_y;
}

/// Calls found(point) for each point that the edges a b and c d share; of a stretch for its ends.
template <class Found>
void meet_edges(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                const LatticePoint& d, const Found& found) {
  const int at_c = side(a, b, c);
  const int at_d = side(a, b, d);
  if (at_c * at_d > 0) return;
  const int at_a = side(c, d, a);
  const int at_b = side(c, d, b);
  if (at_a * at_b > 0) return;
  if (at_c * at_d < 0 && at_a * at_b < 0) {
    found(crossing(a, b, c, d));
    return;
  }
  if (at_c == 0 && within(a, b, c)) found(ExactPoint(c));
  if (at_d == 0 && within(a, b, d)) found(ExactPoint(d));
  if (at_a == 0 && within(c, d, a)) found(ExactPoint(a));
  if (at_b == 0 && within(c, d, b)) found(ExactPoint(b));
}

bool edges_meet(const Ring& ring, std::size_t i, std::size_t j) {
  bool met = false;
  meet_edges(ring[i], next_corner(ring, i), ring[j], next_corner(ring, j),
             [&met](const ExactPoint&) { met = true; });
  return met;
}

void require_simple(const Ring& ring) {
  const std::size_t size = ring.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Box box = box_of(ring[i], next_corner(ring, i));
    for (std::size_t j = i + 2; j < size; ++j) {
      if (i == 0 && j + 1 == size) continue;
      if (!box.meets(box_of(ring[j], next_corner(ring, j)))) continue;
      if (edges_meet(ring, i, j)) throw std::invalid_argument("edges of a polygon meet");
    }
  }
}

/// Whether b adds nothing to the border from a to c, or is the tip of a needle.
bool needless(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return a == b || side(a, b, c) == 0;
}

bool clockwise(const Ring& ring) {
  Int128 twice_area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    twice_area += area(ring[0], ring[i], ring[i + 1]);
  }
  return twice_area < 0;
}

double distance_to_edge(const LatticePoint& p, const LatticePoint& a, const LatticePoint& b) {
  const Vec2 way = metres(b) - metres(a);
  const Vec2 to = metres(p) - metres(a);
  const double share = std::clamp(to.dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (to - share * way).norm();
}

/// Of two edges that do not meet the least distance is at one of their ends.
double distance_of_edges(const Ring& ring, std::size_t i, std::size_t j) {
  return std::min({distance_to_edge(ring[i], ring[j], next_corner(ring, j)),
                   distance_to_edge(next_corner(ring, i), ring[j], next_corner(ring, j)),
                   distance_to_edge(ring[j], ring[i], next_corner(ring, i)),
                   distance_to_edge(next_corner(ring, j), ring[i], next_corner(ring, i))});
}

}  // namespace

bool is_convex(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LatticePoint& middle = next_corner(ring, i);
    if (side(ring[i], middle, ring[(i + 2) % ring.size()]) < 0) return false;
  }
  return true;
}

double thickness(const Ring& ring) {
  const bool convex = is_convex(ring);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (convex) {
      const Vec2 a = metres(ring[i]);
      const Vec2 heading = (metres(next_corner(ring, i)) - a).normalized();
      double width = 0;
      for (const LatticePoint& corner : ring) {
        const Vec2 to = metres(corner) - a;
        width = std::max(width, heading.x() * to.y() - heading.y() * to.x());
      }
      least = std::min(least, width);
      continue;
    }
    for (std::size_t j = i + 2; j < ring.size(); ++j) {
      if (i == 0 && j + 1 == ring.size()) continue;
      least = std::min(least, distance_of_edges(ring, i, j));
    }
  }
  return least;
}

void Box::include(const Box& other) {
  low_x = std::min(low_x, other.low_x);
  low_y = std::min(low_y, other.low_y);
  high_x = std::max(high_x, other.high_x);
  high_y = std::max(high_y, other.high_y);
}

Box box_of(const LatticePoint& a, const LatticePoint& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

Box box_of(const Ring& ring) {
  Box box = box_of(ring.front(), ring.front());
  for (const LatticePoint& corner : ring) box.include(box_of(corner, corner));
  return box;
}

std::vector<Vec2> in_metres(const Ring& ring) {
  std::vector<Vec2> corners;
  for (const LatticePoint& corner : ring) corners.push_back(metres(corner));
  return corners;
}

Ring ring_of(std::span<const Vec2> corners) {
  Ring ring;
  for (const Vec2& corner : corners) ring.push_back(snap(corner));
  for (bool changed = true; changed && ring.size() >= 3;) {
    changed = false;
    for (std::size_t i = 0; i < ring.size() && ring.size() >= 3; ++i) {
      const LatticePoint& before = ring[i == 0 ? ring.size() - 1 : i - 1];
      if (!needless(before, ring[i], next_corner(ring, i))) continue;
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      changed = true;
    }
  }
  if (ring.size() < 3) throw std::invalid_argument("a polygon without an interior");
  require_simple(ring);
  if (clockwise(ring)) std::reverse(ring.begin(), ring.end());
  return ring;
}

std::vector<Meeting> meetings(const Ring& a, const Ring& b) {
  std::vector<Meeting> found;
  const Box around_b = box_of(b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Box box = box_of(a[i], next_corner(a, i));
    if (!box.meets(around_b)) continue;
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (!box.meets(box_of(b[j], next_corner(b, j)))) continue;
      meet_edges(a[i], next_corner(a, i), b[j], next_corner(b, j), [&](const ExactPoint& at) {
        found.push_back({static_cast<int>(i), static_cast<int>(j), at});
      });
    }
  }
  return found;
}

}  // namespace rubicon::travel
