#include "src/motion/coverage/grid.hpp"

#include <cmath>

namespace rubicon::coverage {
namespace {

int sign(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

bool lies_on(const Point& a, const Point& b, const Point& p) {
  return cross(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

}  // namespace

std::int64_t twice_area(const Ring& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += cross(ring[0], ring[i], ring[i + 1]);
  return sum;
}

bool is_orthogonal(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& next = next_corner(ring, i);
    if (ring[i].x != next.x && ring[i].y != next.y) return false;
  }
  return true;
}

Box box_of(const Point& a, const Point& b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

Box box_of(const Ring& ring) {
  Box box{ring[0], ring[0]};
  for (const Point& p : ring) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (!box_of(a, b).meets(box_of(c, d))) return false;
  const int at_c = sign(cross(a, b, c));
  const int at_d = sign(cross(a, b, d));
  const int at_a = sign(cross(c, d, a));
  const int at_b = sign(cross(c, d, b));
  if (at_c * at_d < 0 && at_a * at_b < 0) return true;
  return lies_on(a, b, c) || lies_on(a, b, d) || lies_on(c, d, a) || lies_on(c, d, b);
}

bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return sign(cross(a, b, c)) * sign(cross(a, b, d)) < 0 &&
         sign(cross(c, d, a)) * sign(cross(c, d, b)) < 0;
}

int place_in(const Ring& ring, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = next_corner(ring, i);
    if ((a.y > p.y && b.y > p.y) || (a.y < p.y && b.y < p.y)) continue;
    const std::int64_t side = cross(a, b, p);
    if (side == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x)) return 0;
    if (a.y <= p.y && b.y > p.y && side > 0) inside = !inside;
    if (b.y <= p.y && a.y > p.y && side < 0) inside = !inside;
  }
  return inside ? 1 : -1;
}

bool enters_convex(const Ring& convex, const Point& a, const Point& b) {
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Point& from = convex[i];
    const Point& to = next_corner(convex, i);
    // Two convex sets are apart where an edge of one has the other beyond it.
    if (cross(from, to, a) <= 0 && cross(from, to, b) <= 0) return false;
    const std::int64_t side = cross(a, b, from);
    left = left || side > 0;
    right = right || side < 0;
  }
  return a == b || (left && right);
}

Buckets::Buckets(const Box& box, std::size_t count) : low_(box.low) {
  const auto side = static_cast<std::int64_t>(std::sqrt(static_cast<double>(count))) + 1;
  const std::int64_t longest = std::max<std::int64_t>({box.width(), box.height(), 1});
  const std::int64_t shortest = std::max<std::int64_t>({std::min(box.width(), box.height()), 1});
  // About as many buckets as things, whatever the proportions of the box.
  const double ratio = static_cast<double>(longest) / static_cast<double>(shortest);
  const auto along =
      static_cast<std::int64_t>(static_cast<double>(side) * std::sqrt(std::min(ratio, 64.0)));
  pitch_ = longest / std::min<std::int64_t>(along, 2048) + 1;
  columns_ = box.width() / pitch_ + 1;
  rows_ = box.height() / pitch_ + 1;
  buckets_.resize(static_cast<std::size_t>(columns_ * rows_));
}

Buckets::Range Buckets::columns_in_row(const Point& a, const Point& b, std::int64_t row) const {
  const Range all{column_of(std::min(a.x, b.x)), column_of(std::max(a.x, b.x))};
  if (all.low == all.high || a.y == b.y) return all;
  // The part of the segment in this row and a unit more, so that rounding leaves nothing out.
  const auto bottom = static_cast<double>(low_.y + row * pitch_ - 1);
  const double top = bottom + static_cast<double>(pitch_ + 2);
  const Point& lower = a.y < b.y ? a : b;
  const Point& upper = a.y < b.y ? b : a;
  const auto height = static_cast<double>(upper.y - lower.y);
  const auto run = static_cast<double>(upper.x - lower.x);
  const auto x_at = [&](double y) {
    const double share = std::clamp((y - static_cast<double>(lower.y)) / height, 0.0, 1.0);
    return static_cast<std::int64_t>(static_cast<double>(lower.x) + share * run);
  };
  const std::int64_t low = row == 0 ? lower.x : x_at(bottom);
  const std::int64_t high = row == rows_ - 1 ? upper.x : x_at(top);
  return {column_of(std::min(low, high) - 1), column_of(std::max(low, high) + 1)};
}

void Buckets::add(int item, const Point& a, const Point& b) {
  const auto [row_low, row_high] = rows(a, b);
  for (std::int64_t row = row_low; row <= row_high; ++row) {
    const auto [low, high] = columns_in_row(a, b, row);
    for (std::int64_t column = low; column <= high; ++column) {
      buckets_[static_cast<std::size_t>(row * columns_ + column)].push_back(item);
    }
  }
}

void Buckets::add(int item, const Box& box) {
  for (std::int64_t row = row_of(box.low.y); row <= row_of(box.high.y); ++row) {
    for (std::int64_t c = column_of(box.low.x); c <= column_of(box.high.x); ++c) {
      buckets_[static_cast<std::size_t>(row * columns_ + c)].push_back(item);
    }
  }
}

}  // namespace rubicon::coverage
