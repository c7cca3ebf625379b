#include "src/motion/collision/base/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace rubicon::collision {
namespace {

using Vec2 = Eigen::Vector2d;
using Loop = std::vector<int>;

/// A corner nearer than this share of its sides to the straight line is none; at 100 m this is
/// 1e-10 m.
constexpr double kStraight = 1e-12;

/// Twice the area of the triangle, positive when it turns left.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

double twice_area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += turn(polygon[0], polygon[i], polygon[i + 1]);
  return sum;
}

bool within_box(const Vec2& a, const Vec2& b, const Vec2& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
         std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

/// Whether the closed segments a-b and c-d have a point in common.
bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double c_side = turn(a, b, c);
  const double d_side = turn(a, b, d);
  const double a_side = turn(c, d, a);
  const double b_side = turn(c, d, b);
  const auto opposite = [](double p, double q) { return (p > 0 && q < 0) || (p < 0 && q > 0); };
  if (opposite(c_side, d_side) && opposite(a_side, b_side)) return true;
  return (c_side == 0 && within_box(a, b, c)) || (d_side == 0 && within_box(a, b, d)) ||
         (a_side == 0 && within_box(c, d, a)) || (b_side == 0 && within_box(c, d, b));
}

bool is_straight(const Vec2& before, const Vec2& at, const Vec2& after) {
  const double sides = (at - before).norm() * (after - at).norm();
  return std::fabs(turn(before, at, after)) <= kStraight * sides &&
         (at - before).dot(after - at) > 0;
}

void require_no_crossing(const Polygon& polygon) {
  const int count = static_cast<int>(polygon.size());
  const auto left = [&](int side) {
    return std::min(polygon[side].x(), polygon[(side + 1) % count].x());
  };
  const auto right = [&](int side) {
    return std::max(polygon[side].x(), polygon[(side + 1) % count].x());
  };
  std::vector<int> order(polygon.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return std::make_pair(left(i), i) < std::make_pair(left(j), j); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (std::size_t m = k + 1; m < order.size() && left(order[m]) <= right(order[k]); ++m) {
      const int i = std::min(order[k], order[m]);
      const int j = std::max(order[k], order[m]);
      const bool neighbours = j == i + 1 || (i == 0 && j == count - 1);
      const Vec2& a = polygon[i];
      const Vec2& b = polygon[(i + 1) % count];
      const Vec2& c = polygon[j];
      const Vec2& d = polygon[(j + 1) % count];
      bool meet = false;
      if (!neighbours) {
        meet = segments_meet(a, b, c, d);
      } else {
        // Sides that follow each other must not fold back.
        const bool forward = j == i + 1;
        const Vec2 in = forward ? Vec2(b - a) : Vec2(d - c);
        const Vec2 out = forward ? Vec2(d - c) : Vec2(b - a);
        meet = cross(in, out) == 0 && in.dot(out) < 0;
      }
      if (meet) {
        throw std::invalid_argument(
            fmt::format("the polygon of a prism crosses or touches itself: side {} ({}, {})-({}, "
                        "{}) meets side {} ({}, {})-({}, {})",
                        i + 1, a.x(), a.y(), b.x(), b.y(), j + 1, c.x(), c.y(), d.x(), d.y()));
      }
    }
  }
}

bool contains_no_corner(const Polygon& polygon, const Loop& loop, std::size_t ear) {
  const std::size_t count = loop.size();
  const int before = loop[(ear + count - 1) % count];
  const int at = loop[ear];
  const int after = loop[(ear + 1) % count];
  const Vec2& a = polygon[before];
  const Vec2& b = polygon[at];
  const Vec2& c = polygon[after];
  return std::none_of(loop.begin(), loop.end(), [&](int index) {
    if (index == before || index == at || index == after) return false;
    const Vec2& p = polygon[index];
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  });
}

std::size_t find_ear(const Polygon& polygon, const Loop& loop) {
  const std::size_t count = loop.size();
  std::size_t best = 0;
  double best_turn = -1;
  for (std::size_t i = 0; i < count; ++i) {
    const double corner = turn(polygon[loop[(i + count - 1) % count]], polygon[loop[i]],
                               polygon[loop[(i + 1) % count]]);
    if (corner < 0) continue;
    if (contains_no_corner(polygon, loop, i)) return i;
    if (corner > best_turn) {
      best = i;
      best_turn = corner;
    }
  }
  return best;  // only rounding leaves a simple polygon without an ear
}

std::vector<Loop> triangles_of(const Polygon& polygon) {
  Loop loop(polygon.size());
  std::iota(loop.begin(), loop.end(), 0);
  std::vector<Loop> triangles;
  while (loop.size() > 3) {
    const std::size_t ear = find_ear(polygon, loop);
    const std::size_t count = loop.size();
    triangles.push_back({loop[(ear + count - 1) % count], loop[ear], loop[(ear + 1) % count]});
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back(loop);
  return triangles;
}

bool is_convex(const Polygon& polygon, const Loop& loop) {
  const std::size_t count = loop.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (turn(polygon[loop[i]], polygon[loop[(i + 1) % count]], polygon[loop[(i + 2) % count]]) < 0)
      return false;
  }
  return true;
}

/// The union of two loops along the side from-to of the first (to-from of the second).
Loop joined(const Loop& first, const Loop& second, int from, int to) {
  Loop result;
  const auto append_from = [&result](const Loop& loop, int begin) {
    const auto start = std::find(loop.begin(), loop.end(), begin) - loop.begin();
    const std::size_t count = loop.size();
    for (std::size_t k = 0; k + 1 < count; ++k) {
      result.push_back(loop[(static_cast<std::size_t>(start) + k) % count]);
    }
  };
  append_from(first, to);
  append_from(second, from);
  return result;
}

}  // namespace

Polygon simple_polygon(const Polygon& polygon) {
  Polygon corners;
  for (const Vec2& corner : polygon) {
    if (!corner.allFinite())
      throw std::invalid_argument("a corner of a prism's polygon is not finite");
    if (corners.empty() || corners.back() != corner) corners.push_back(corner);
  }
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  if (corners.size() < 3) {
    throw std::invalid_argument(fmt::format(
        "the polygon of a prism has {} different corners, expected at least 3", corners.size()));
  }
  require_no_crossing(corners);
  if (twice_area(corners) < 0) std::reverse(corners.begin(), corners.end());
  Polygon result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2& before = result.empty() ? corners.back() : result.back();
    if (!is_straight(before, corners[i], corners[(i + 1) % corners.size()]))
      result.push_back(corners[i]);
  }
  if (result.size() < 3 || !(twice_area(result) > 0)) {
    throw std::invalid_argument("the polygon of a prism has no area");
  }
  return result;
}

std::vector<Polygon> convex_parts(const Polygon& polygon) {
  std::vector<Loop> parts = triangles_of(polygon);
  std::map<std::pair<int, int>, std::size_t> owner;  // directed side -> part
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (std::size_t k = 0; k < 3; ++k) owner[{parts[part][k], parts[part][(k + 1) % 3]}] = part;
  }
  const auto sides = owner;
  for (const auto& [side, unused] : sides) {
    const auto [from, to] = side;
    if (from > to || !sides.contains({to, from})) continue;
    const std::size_t first = owner.at({from, to});
    const std::size_t second = owner.at({to, from});
    const Loop whole = joined(parts[first], parts[second], from, to);
    if (!is_convex(polygon, whole)) continue;
    owner.erase({from, to});
    owner.erase({to, from});
    parts[first] = whole;
    parts[second].clear();
    for (std::size_t k = 0; k < whole.size(); ++k) {
      owner[{whole[k], whole[(k + 1) % whole.size()]}] = first;
    }
  }
  std::vector<Polygon> result;
  for (const Loop& loop : parts) {
    if (loop.empty()) continue;
    Polygon part;
    for (const int index : loop) part.push_back(polygon[index]);
    if (twice_area(part) > 0) result.push_back(part);
  }
  return result;
}

}  // namespace rubicon::collision
