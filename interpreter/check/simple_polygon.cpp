#include "interpreter/check/simple_polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rubicon::interpreter {

namespace {

using Point = Eigen::Vector2d;

double cross(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

int side(const Point& a, const Point& b, const Point& c) {
  const double value = cross(a, b, c);
  return (value > 0) - (value < 0);
}

bool inside_bounds(const Point& a, const Point& b, const Point& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
         std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

/// Whether the closed segments ab and cd have a point in common.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int c_side = side(a, b, c), d_side = side(a, b, d);
  const int a_side = side(c, d, a), b_side = side(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && inside_bounds(a, b, c)) || (d_side == 0 && inside_bounds(a, b, d)) ||
         (a_side == 0 && inside_bounds(c, d, a)) || (b_side == 0 && inside_bounds(c, d, b));
}

}  // namespace

std::optional<std::string> polygon_fault(const std::vector<Point>& polygon) {
  const std::size_t count = polygon.size();
  if (count < 3) return fmt::format("expected at least 3 corners, found {}", count);
  const auto at = [&](std::size_t i) -> const Point& { return polygon[i % count]; };
  double area = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Point &a = at(i), &b = at(i + 1), &c = at(i + 2);
    if (a == b) return fmt::format("corner {} stands twice", i + 1);
    if (side(a, b, c) == 0 && (a - b).dot(c - b) > 0) {
      return fmt::format("its edge folds back at corner {}", (i + 1) % count + 1);
    }
    area += cross(polygon[0], a, b);
  }

  // Edges in the order of their smallest x: only those that overlap in x can meet.
  const auto low = [&](std::size_t i) { return std::min(at(i).x(), at(i + 1).x()); };
  const auto high = [&](std::size_t i) { return std::max(at(i).x(), at(i + 1).x()); };
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return low(i) < low(j); });
  for (std::size_t m = 0; m < count; ++m) {
    const std::size_t i = order[m];
    for (std::size_t n = m + 1; n < count && low(order[n]) <= high(i); ++n) {
      const std::size_t j = order[n];
      const std::size_t apart = i < j ? j - i : i - j;
      if (apart == 1 || apart == count - 1) continue;
      if (meet(at(i), at(i + 1), at(j), at(j + 1))) {
        return fmt::format("its edges after corners {} and {} meet", std::min(i, j) + 1,
                           std::max(i, j) + 1);
      }
    }
  }
  if (!(std::fabs(area) > 0)) return "its corners enclose no area";
  return std::nullopt;
}

}  // namespace rubicon::interpreter
