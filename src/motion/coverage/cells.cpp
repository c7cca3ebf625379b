#include "src/motion/coverage/cells.hpp"

#include <array>
#include <map>
#include <set>

#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return quotient * b > a ? quotient - 1 : quotient;  // b > 0
}

const Side& side_at(const std::vector<Side>& chain, std::int64_t y) {
  const auto found =
      std::lower_bound(chain.begin(), chain.end(), y,
                       [](const Side& side, std::int64_t level) { return side.high.y < level; });
  return found == chain.end() ? chain.back() : *found;
}

/// Sweeps a line along x upwards over the edges of a floor. Between two corners it is cut into
/// stretches of floor, each between a left and a right edge, each in one open cell.
class CellSweep {
 public:
  CellSweep(std::span<const Ring> rings, bool trapezoids)
      : trapezoids_(trapezoids), active_(Before{&sides_}) {
    std::map<std::int64_t, Level> levels;
    for (const Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& a = ring[i];
        const Point& b = next_corner(ring, i);
        if (a.y == b.y) continue;
        const int number = static_cast<int>(sides_.size());
        const bool down = b.y < a.y;
        sides_.push_back(down ? Side{b, a} : Side{a, b});
        is_left_.push_back(down);
        levels[sides_.back().low.y].starts.push_back(number);
        levels[sides_.back().high.y].ends.push_back(number);
      }
    }
    cell_of_.assign(sides_.size(), -1);
    for (const auto& [y, level] : levels) step(y, level);
  }

  CellGraph take() { return std::move(graph_); }

 private:
  struct Level {
    std::vector<int> starts;
    std::vector<int> ends;
  };
  /// Order along x of edges that one line along x meets and that do not cross.
  struct Before {
    const std::vector<Side>* sides;
    bool operator()(int a, int b) const {
      if (a == b) return false;
      const Side& s = (*sides)[at(a)];
      const Side& t = (*sides)[at(b)];
      if (s.low.y <= t.low.y) {
        std::int64_t side = cross(s.low, s.high, t.low);
        if (side == 0) side = cross(s.low, s.high, t.high);
        return side < 0 || (side == 0 && a < b);
      }
      std::int64_t side = cross(t.low, t.high, s.low);
      if (side == 0) side = cross(t.low, t.high, s.high);
      return side > 0 || (side == 0 && a < b);
    }
  };
  struct Stretch {
    int left = 0;
    int right = 0;
    double x0 = 0;
    double x1 = 0;
  };

  double x_at(int side, std::int64_t y) const {
    const Side& s = sides_[at(side)];
    if (s.low.y == y) return static_cast<double>(s.low.x);
    if (s.high.y == y) return static_cast<double>(s.high.x);
    return static_cast<double>(s.low.x) +
           static_cast<double>(s.high.x - s.low.x) *
               (static_cast<double>(y - s.low.y) / static_cast<double>(s.high.y - s.low.y));
  }
  Stretch stretch(int left, int right, std::int64_t y) const {
    return {left, right, x_at(left, y), x_at(right, y)};
  }
  /// Whether one edge goes on where another one ended, or is the same.
  bool goes_on(int before, int after) const {
    return before == after || sides_[at(before)].high == sides_[at(after)].low;
  }

  void step(std::int64_t y, const Level& level) {
    std::set<int> touched;  // open cells
    for (const int side : level.ends) touched.insert(cell_of_[at(side)]);
    for (const int side : level.starts) {
      const auto next = active_.lower_bound(side);
      if (next == active_.begin()) continue;
      const int before = *std::prev(next);
      if (is_left_[at(before)]) touched.insert(cell_of_[at(before)]);
    }
    std::vector<Stretch> old;
    std::set<int, Before> lefts(Before{&sides_});
    for (const int cell : touched) {
      const auto [left, right] = edges_of_[at(cell)];
      old.push_back(stretch(left, right, y));
      if (sides_[at(left)].high.y > y) lefts.insert(left);
    }
    const auto by_x = [](const Stretch& a, const Stretch& b) {
      return a.x0 < b.x0 || (a.x0 == b.x0 && a.x1 < b.x1);
    };
    std::sort(old.begin(), old.end(), by_x);
    for (const int side : level.ends) active_.erase(side);
    for (const int side : level.starts) {
      active_.insert(side);
      if (is_left_[at(side)]) lefts.insert(side);
    }
    std::vector<Stretch> now;
    for (const int left : lefts) now.push_back(stretch(left, *active_.upper_bound(left), y));
    join(y, old, now);
  }

  void join(std::int64_t y, const std::vector<Stretch>& old, const std::vector<Stretch>& now) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    std::vector<int> of_old(old.size(), 0);
    std::vector<int> of_now(now.size(), 0);
    for (std::size_t i = 0, j = 0; i < old.size() && j < now.size();) {
      if (std::max(old[i].x0, now[j].x0) < std::min(old[i].x1, now[j].x1)) {
        pairs.emplace_back(i, j);
        ++of_old[i];
        ++of_now[j];
      }
      old[i].x1 < now[j].x1 ? ++i : ++j;
    }
    std::vector<int> cells(now.size(), -1);
    std::vector<int> before(old.size());
    for (std::size_t i = 0; i < old.size(); ++i) before[i] = cell_of_[at(old[i].left)];
    for (const auto& [i, j] : pairs) {
      const bool same = old[i].left == now[j].left && old[i].right == now[j].right;
      if (of_old[i] != 1 || of_now[j] != 1 || (trapezoids_ && !same)) continue;
      if (goes_on(old[i].left, now[j].left) && goes_on(old[i].right, now[j].right)) {
        cells[j] = before[i];
      }
    }
    for (std::size_t j = 0; j < now.size(); ++j) {
      if (cells[j] < 0) {
        cells[j] = static_cast<int>(graph_.cells.size());
        graph_.cells.push_back({y, y, {}, {}});
        edges_of_.emplace_back();
      }
      Cell& cell = graph_.cells[at(cells[j])];
      const int left = now[j].left;
      const int right = now[j].right;
      if (cell.left.empty() || cell_of_[at(left)] != cells[j]) {
        cell.left.push_back(sides_[at(left)]);
      }
      if (cell.right.empty() || cell_of_[at(right)] != cells[j]) {
        cell.right.push_back(sides_[at(right)]);
      }
    }
    for (const auto& [i, j] : pairs) {
      if (before[i] == cells[j]) continue;
      const double x0 = std::max(old[i].x0, now[j].x0);
      const double x1 = std::min(old[i].x1, now[j].x1);
      graph_.doors.push_back({before[i],
                              cells[j],
                              {static_cast<std::int64_t>(std::ceil(x0)), y},
                              {static_cast<std::int64_t>(std::floor(x1)), y}});
    }
    for (std::size_t i = 0; i < old.size(); ++i) graph_.cells[at(before[i])].top = y;
    for (std::size_t j = 0; j < now.size(); ++j) {
      cell_of_[at(now[j].left)] = cell_of_[at(now[j].right)] = cells[j];
      edges_of_[at(cells[j])] = {now[j].left, now[j].right};
    }
  }

  struct Edges {
    int left = -1;
    int right = -1;
  };
  bool trapezoids_;
  std::vector<Side> sides_;
  std::vector<bool> is_left_;  ///< of each side: floor begins there, going along x
  std::set<int, Before> active_;
  std::vector<int> cell_of_;     ///< of each active side
  std::vector<Edges> edges_of_;  ///< of each open cell, at the line
  CellGraph graph_;
};

/// A side of a rectangle: its coordinate across, its range along, whose it is.
struct Flank {
  std::int64_t across;
  std::int64_t low;
  std::int64_t high;
  int owner;
  friend auto operator<=>(const Flank&, const Flank&) = default;
};

/// Calls `visit(end, begin, low, high)` for each side of `ends` that has a stretch in common with
/// one of `begins`; both sorted.
template <typename Visit>
void for_each_contact(const std::vector<Flank>& ends, const std::vector<Flank>& begins,
                      const Visit& visit) {
  for (std::size_t i = 0, j = 0; i < ends.size() && j < begins.size();) {
    const Flank& a = ends[i];
    const Flank& b = begins[j];
    if (a.across != b.across) {
      a.across < b.across ? ++i : ++j;
      continue;
    }
    const std::int64_t low = std::max(a.low, b.low);
    const std::int64_t high = std::min(a.high, b.high);
    if (low < high) visit(a.owner, b.owner, low, high);
    a.high < b.high ? ++i : ++j;
  }
}

}  // namespace

std::int64_t Side::x_below(std::int64_t y) const {
  return low.x + floor_div((high.x - low.x) * (y - low.y), high.y - low.y);
}
std::int64_t Side::x_above(std::int64_t y) const {
  return low.x - floor_div((low.x - high.x) * (y - low.y), high.y - low.y);
}

std::int64_t Cell::left_at(std::int64_t y) const { return side_at(left, y).x_above(y); }
std::int64_t Cell::right_at(std::int64_t y) const { return side_at(right, y).x_below(y); }

Ring Cell::ring() const {
  Ring result;
  const auto add = [&](const Point& p) {
    if (result.empty() || (result.back() != p && result.front() != p)) result.push_back(p);
  };
  add({left_at(bottom), bottom});
  add({right_at(bottom), bottom});
  for (const Side& side : right) {
    if (side.high.y > bottom && side.high.y < top) add(side.high);
  }
  add({right.back().x_below(top), top});
  add({left.back().x_above(top), top});
  for (std::size_t i = left.size(); i-- > 0;) {
    if (left[i].high.y > bottom && left[i].high.y < top) add(left[i].high);
  }
  return result;
}

bool Cell::is_rectangle() const {
  return left.size() == 1 && right.size() == 1 && left[0].low.x == left[0].high.x &&
         right[0].low.x == right[0].high.x;
}

Cell cell_of(const Box& box) {
  return {box.low.y,
          box.high.y,
          {{box.low, {box.low.x, box.high.y}}},
          {{{box.high.x, box.low.y}, box.high}}};
}

CellGraph cells_by_sweep(std::span<const Ring> rings, bool trapezoids) {
  return CellSweep(rings, trapezoids).take();
}

std::vector<Door> doors_between(std::span<const Box> rectangles) {
  std::array<std::vector<Flank>, 4> flanks;
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    const Box& box = rectangles[i];
    const int owner = static_cast<int>(i);
    flanks[0].push_back({box.high.x, box.low.y, box.high.y, owner});
    flanks[1].push_back({box.low.x, box.low.y, box.high.y, owner});
    flanks[2].push_back({box.high.y, box.low.x, box.high.x, owner});
    flanks[3].push_back({box.low.y, box.low.x, box.high.x, owner});
  }
  for (auto& sides : flanks) std::sort(sides.begin(), sides.end());
  std::vector<Door> doors;
  for_each_contact(flanks[0], flanks[1], [&](int a, int b, std::int64_t low, std::int64_t high) {
    const std::int64_t x = rectangles[at(a)].high.x;
    doors.push_back({std::min(a, b), std::max(a, b), {x, low}, {x, high}});
  });
  for_each_contact(flanks[2], flanks[3], [&](int a, int b, std::int64_t low, std::int64_t high) {
    const std::int64_t y = rectangles[at(a)].high.y;
    doors.push_back({std::min(a, b), std::max(a, b), {low, y}, {high, y}});
  });
  std::sort(doors.begin(), doors.end(),
            [](const Door& p, const Door& q) { return std::pair(p.a, p.b) < std::pair(q.a, q.b); });
  return doors;
}

}  // namespace rubicon::coverage
