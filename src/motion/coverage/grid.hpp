#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <vector>

namespace rubicon::coverage {

/// Whole units of the grid of corners in a metre: a unit is 0.1 mm. Corners are moved by up to half
/// of it; from there on areas add up exactly, and what lies on which side is decided in whole
/// numbers.
inline constexpr std::int64_t kUnitsPerMetre = 10'000;
/// Places lie within this many metres of the origin in x and y: then every product of two
/// differences fits in 64 bits, turned floors included.
inline constexpr double kReach = 10'000;

/// A place of the plan view, m, x east and y north.
struct Place {
  double x = 0;
  double y = 0;
};

/// A place on the grid, in units.
struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend auto operator<=>(const Point&, const Point&) = default;
};

/// The grid's number next to a length in metres, halves away from 0; the length is finite and
/// within 4 kReach.
inline std::int64_t in_units(double metres) {
  const double units = metres * static_cast<double>(kUnitsPerMetre);
  return static_cast<std::int64_t>(units < 0 ? units - 0.5 : units + 0.5);
}
inline double in_metres(std::int64_t units) {
  return static_cast<double>(units) / static_cast<double>(kUnitsPerMetre);
}
inline Point snap(const Place& place) { return {in_units(place.x), in_units(place.y)}; }
inline Place metres(const Point& point) { return {in_metres(point.x), in_metres(point.y)}; }

/// Twice the area of a, b, c in square units: positive where c is left of the way from a to b.
inline std::int64_t cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
inline std::int64_t dot(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y);
}

/// Straight distance in units.
inline double distance(const Point& a, const Point& b) {
  const auto x = static_cast<double>(b.x - a.x);
  const auto y = static_cast<double>(b.y - a.y);
  return std::sqrt(x * x + y * y);
}

/// The corners of a polygon, counter-clockwise where nothing else is said.
using Ring = std::vector<Point>;

inline const Point& next_corner(const Ring& ring, std::size_t i) {
  return ring[i + 1 < ring.size() ? i + 1 : 0];
}
inline const Point& corner_before(const Ring& ring, std::size_t i) {
  return ring[i > 0 ? i - 1 : ring.size() - 1];
}

/// Twice the area in square units, positive for a counter-clockwise ring.
std::int64_t twice_area(const Ring& ring);
/// Whether every edge is parallel to an axis.
bool is_orthogonal(const Ring& ring);

/// A rectangle parallel to the axes, border included.
struct Box {
  Point low;
  Point high;
  bool meets(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y;
  }
  /// Whether the interiors have a point in common.
  bool overlaps(const Box& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y &&
           other.low.y < high.y;
  }
  std::int64_t width() const { return high.x - low.x; }
  std::int64_t height() const { return high.y - low.y; }
  Ring ring() const { return {low, {high.x, low.y}, high, {low.x, high.y}}; }
  friend bool operator==(const Box&, const Box&) = default;
};
Box box_of(const Point& a, const Point& b);
Box box_of(const Ring& ring);

/// Whether the closed segments a b and c d have a point in common.
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d);
/// Whether they cross in a point that is no end of either.
bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d);
/// Where a point is with regard to a ring of either sense: 1 inside, 0 on it, -1 outside.
int place_in(const Ring& ring, const Point& p);
/// Whether the segment a b meets the interior of a convex counter-clockwise ring.
bool enters_convex(const Ring& convex, const Point& a, const Point& b);

/// Which of many things lie near a line: a grid of buckets over a box, each with the numbers of
/// what it may touch.
class Buckets {
 public:
  /// For about `count` things in a box.
  Buckets(const Box& box, std::size_t count);
  void add(int item, const Point& a, const Point& b);
  void add(int item, const Box& box);

  /// Calls `visit(item)` for each thing that may be near the segment, some more than once, until
  /// one call says true; whether one did.
  template <typename Visit>
  bool any_near(const Point& a, const Point& b, const Visit& visit) const {
    const auto [row_low, row_high] = rows(a, b);
    for (std::int64_t row = row_low; row <= row_high; ++row) {
      const auto [low, high] = columns_in_row(a, b, row);
      for (std::int64_t column = low; column <= high; ++column) {
        for (const int item : buckets_[static_cast<std::size_t>(row * columns_ + column)]) {
          if (visit(item)) return true;
        }
      }
    }
    return false;
  }
  template <typename Visit>
  bool any_in(const Box& box, const Visit& visit) const {
    for (std::int64_t row = row_of(box.low.y); row <= row_of(box.high.y); ++row) {
      for (std::int64_t c = column_of(box.low.x); c <= column_of(box.high.x); ++c) {
        for (const int item : buckets_[static_cast<std::size_t>(row * columns_ + c)]) {
          if (visit(item)) return true;
        }
      }
    }
    return false;
  }

 private:
  struct Range {
    std::int64_t low;
    std::int64_t high;
  };
  std::int64_t column_of(std::int64_t x) const {
    return std::clamp<std::int64_t>((x - low_.x) / pitch_, 0, columns_ - 1);
  }
  std::int64_t row_of(std::int64_t y) const {
    return std::clamp<std::int64_t>((y - low_.y) / pitch_, 0, rows_ - 1);
  }
  Range rows(const Point& a, const Point& b) const {
    return {row_of(std::min(a.y, b.y)), row_of(std::max(a.y, b.y))};
  }
  Range columns_in_row(const Point& a, const Point& b, std::int64_t row) const;

  Point low_;
  std::int64_t pitch_ = 1;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
  std::vector<std::vector<int>> buckets_;
};

}  // namespace rubicon::coverage
