#include "src/exchange/ifc/polygon_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

namespace rubicon::ifc {

namespace {

using math::Vec3;
using Triangle = std::array<int, 3>;

__extension__ using Wide = __int128;

/// A corner in the plane, in whole steps.
struct Corner {
  std::int64_t x = 0, y = 0;
  int index = 0;  ///< of the point

  bool same_place(const Corner& other) const { return x == other.x && y == other.y; }
};

/// Coordinates have this many steps: products of differences stay far below 2^127.
constexpr double kSteps = 1099511627776.0;  // 2^40

/// Above zero: c lies left of the line from a to b.
int side(const Corner& a, const Corner& b, const Corner& c) {
  const Wide value = Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x);
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

Wide area2(const std::vector<Corner>& loop) {
  Wide sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Corner& a = loop[i];
    const Corner& b = loop[(i + 1) % loop.size()];
    sum += Wide(a.x) * b.y - Wide(a.y) * b.x;
  }
  return sum;
}

/// Whether p lies on the line between a and b, the ends included; they are in line.
bool within(const Corner& a, const Corner& b, const Corner& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

/// Whether the lines from a to b and from c to d meet elsewhere than at common ends.
bool blocks(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const int abc = side(a, b, c);
  const int abd = side(a, b, d);
  const int cda = side(c, d, a);
  const int cdb = side(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  const auto touches = [](int where, const Corner& p, const Corner& q, const Corner& r) {
    return where == 0 && !r.same_place(p) && !r.same_place(q) && within(p, q, r);
  };
  return touches(abc, a, b, c) || touches(abd, a, b, d) || touches(cda, c, d, a) ||
         touches(cdb, c, d, b);
}

/// Whether the direction from `at` to `to` leads into the area, whose outline runs from `before`
/// over `at` to `after`.
bool leads_inside(const Corner& before, const Corner& at, const Corner& after, const Corner& to) {
  if (side(before, at, after) >= 0) return side(at, to, before) > 0 && side(at, after, to) > 0;
  return !(side(at, to, after) >= 0 && side(at, before, to) >= 0);
}

/// The corners of an outline by where they are, to look at those near an ear only.
class CornerGrid {
 public:
  explicit CornerGrid(const std::vector<Corner>& outline) : gone_(outline.size(), 0) {
    low_x_ = low_y_ = std::numeric_limits<std::int64_t>::max();
    std::int64_t high_x = std::numeric_limits<std::int64_t>::min();
    std::int64_t high_y = high_x;
    for (const Corner& p : outline) {
      low_x_ = std::min(low_x_, p.x);
      low_y_ = std::min(low_y_, p.y);
      high_x = std::max(high_x, p.x);
      high_y = std::max(high_y, p.y);
    }
    // About four corners in a square; small outlines are not worth it.
    constexpr std::size_t kSmall = 16;
    if (outline.size() > kSmall) {
      across_ = static_cast<std::int64_t>(std::sqrt(static_cast<double>(outline.size()) / 4));
    }
    width_ = 1 + (high_x - low_x_) / across_;
    height_ = 1 + (high_y - low_y_) / across_;
    squares_.resize(static_cast<std::size_t>(across_ * across_));
    for (std::size_t i = 0; i < outline.size(); ++i) {
      squares_[square(column(outline[i].x), row(outline[i].y))].push_back(i);
    }
  }

  void remove(std::size_t i) { gone_[i] = 1; }

  /// Whether `f` holds for a corner that is left and may lie within a triangle.
  template <class F>
  bool any_near(const Corner& a, const Corner& b, const Corner& c, WorkBudget& budget, F f) const {
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [bottom, top] = std::minmax({a.y, b.y, c.y});
    for (std::int64_t v = row(bottom); v <= row(top); ++v) {
      for (std::int64_t u = column(left); u <= column(right); ++u) {
        const std::vector<std::size_t>& near = squares_[square(u, v)];
        if (!budget.spend(1 + near.size())) return true;
        for (const std::size_t i : near) {
          if (gone_[i] == 0 && f(i)) return true;
        }
      }
    }
    return false;
  }

 private:
  std::int64_t column(std::int64_t x) const { return (x - low_x_) / width_; }
  std::int64_t row(std::int64_t y) const { return (y - low_y_) / height_; }
  std::size_t square(std::int64_t u, std::int64_t v) const {
    return static_cast<std::size_t>(v * across_ + u);
  }

  std::int64_t low_x_ = 0, low_y_ = 0, width_ = 1, height_ = 1, across_ = 1;
  std::vector<std::vector<std::size_t>> squares_;
  std::vector<char> gone_;
};

class Cutter {
 public:
  Cutter(const std::vector<Vec3>& points, const Vec3& normal, WorkBudget& budget, double thin)
      : points_(points), budget_(budget), thin_(thin) {
    normal.cwiseAbs().maxCoeff(&axis_);
    turned_ = normal[axis_] < 0;
  }

  bool add(const Loop& loop) {
    for (const int index : loop) {
      const Vec3& p = points_[static_cast<std::size_t>(index)];
      if (!p.allFinite()) return false;
      low_ = low_.cwiseMin(p);
      high_ = high_.cwiseMax(p);
    }
    loops_.push_back(loop);
    return true;
  }

  bool crosses() {
    if (!set_scale()) return true;
    std::vector<std::pair<Corner, Corner>> sides;
    for (const Loop& loop : loops_) {
      const std::vector<Corner> corners = in_steps(loop);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        sides.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
      }
    }
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (!budget_.spend(i)) return true;
      const auto& [a, b] = sides[i];
      for (std::size_t k = 0; k < i; ++k) {
        const auto& [c, d] = sides[k];
        if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
      }
    }
    return false;
  }

  std::optional<std::vector<Triangle>> cut() {
    if (!set_scale()) return std::nullopt;
    std::vector<std::vector<Corner>> outlines;
    std::vector<std::vector<Corner>> holes;
    for (const Loop& loop : loops_) {
      std::vector<Corner> corners = in_steps(loop);
      const Wide area = area2(corners);
      if (area == 0 || is_thin(area, corners)) {
        close_slit(loop);
      } else {
        (area > 0 ? outlines : holes).push_back(std::move(corners));
      }
    }
    if (outlines.empty() && (thin_ == 0 || !holes.empty())) return std::nullopt;
    std::vector<std::vector<std::vector<Corner>>> of(outlines.size());
    for (std::vector<Corner>& hole : holes) {
      const std::size_t owner = owner_of(hole, outlines);
      if (owner == outlines.size()) return std::nullopt;
      of[owner].push_back(std::move(hole));
    }
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      if (!join(outlines[i], of[i]) || !clip(outlines[i])) return std::nullopt;
    }
    return std::move(triangles_);
  }

 private:
  bool set_scale() {
    const double size = (high_ - low_).maxCoeff();
    if (!(size > 0) || !std::isfinite(size)) return false;
    int exponent = 0;
    std::frexp(size, &exponent);
    scale_ = std::ldexp(kSteps, -exponent);
    return std::isfinite(scale_);
  }

  std::vector<Corner> in_steps(const Loop& loop) const {
    const int u = (axis_ + 1) % 3;
    const int v = (axis_ + 2) % 3;
    std::vector<Corner> corners;
    for (const int index : loop) {
      const Vec3 p = (points_[static_cast<std::size_t>(index)] - low_) * scale_;
      Corner corner{std::llround(p[u]), std::llround(p[v]), index};
      if (turned_) std::swap(corner.x, corner.y);
      corners.push_back(corner);
    }
    return corners;
  }

  bool is_thin(Wide area, const std::vector<Corner>& corners) const {
    double length = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      length += distance(corners[i], corners[(i + 1) % corners.size()]);
    }
    return std::fabs(static_cast<double>(area)) <= thin_ * scale_ * length;
  }

  static double distance(const Corner& a, const Corner& b) {
    const auto x = static_cast<double>(a.x - b.x);
    const auto y = static_cast<double>(a.y - b.y);
    return std::sqrt(x * x + y * y);
  }

  /// A loop in one line has no area, but the neighbours that it runs along must stay joined.
  void close_slit(const Loop& loop) {
    for (std::size_t i = 2; i < loop.size(); ++i) {
      triangles_.push_back({loop[0], loop[i - 1], loop[i]});
    }
  }

  /// The smallest outline around a hole.
  std::size_t owner_of(const std::vector<Corner>& hole,
                       const std::vector<std::vector<Corner>>& outlines) const {
    std::size_t best = outlines.size();
    Wide best_area = 0;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      const Wide area = area2(outlines[i]);
      if ((best == outlines.size() || area < best_area) && is_inside(hole, outlines[i])) {
        best = i;
        best_area = area;
      }
    }
    return best;
  }

  /// By the first corner that is not on the outline itself; where all are, it is inside.
  static bool is_inside(const std::vector<Corner>& hole, const std::vector<Corner>& outline) {
    for (const Corner& p : hole) {
      bool on_line = false;
      bool inside = false;
      for (std::size_t i = 0; i < outline.size() && !on_line; ++i) {
        const Corner& a = outline[i];
        const Corner& b = outline[(i + 1) % outline.size()];
        on_line = side(a, b, p) == 0 && within(a, b, p);
        if ((a.y > p.y) != (b.y > p.y) && (side(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
      }
      if (!on_line) return inside;
    }
    return true;
  }

  /// Makes one outline of it and its holes.
  bool join(std::vector<Corner>& outline, std::vector<std::vector<Corner>>& holes) {
    const auto right = [](const Corner& a, const Corner& b) {
      return a.x != b.x ? a.x < b.x : a.y < b.y;
    };
    for (std::vector<Corner>& hole : holes) {
      std::rotate(hole.begin(), std::max_element(hole.begin(), hole.end(), right), hole.end());
    }
    std::stable_sort(holes.begin(), holes.end(),
                     [&](const auto& a, const auto& b) { return right(b[0], a[0]); });
    for (std::size_t h = 0; h < holes.size(); ++h) {
      const std::optional<std::size_t> at = bridge(outline, holes, h);
      if (!at) return false;
      std::vector<Corner> more = holes[h];
      more.push_back(holes[h].front());
      more.push_back(outline[*at]);
      outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(*at) + 1, more.begin(),
                     more.end());
    }
    return true;
  }

  /// The corner of the outline that hole `h` is joined to: the nearest that is seen from its first
  /// corner.
  std::optional<std::size_t> bridge(const std::vector<Corner>& outline,
                                    const std::vector<std::vector<Corner>>& holes, std::size_t h) {
    const Corner& from = holes[h].front();
    std::vector<std::pair<double, std::size_t>> order;
    if (!budget_.spend(2 * outline.size())) return std::nullopt;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const double x = static_cast<double>(outline[i].x - from.x);
      const double y = static_cast<double>(outline[i].y - from.y);
      order.emplace_back(x * x + y * y, i);
    }
    // The nearest are tried first; most often the first will do.
    const auto farther = std::greater<>();
    std::make_heap(order.begin(), order.end(), farther);
    for (; !order.empty(); order.pop_back()) {
      std::pop_heap(order.begin(), order.end(), farther);
      const std::size_t i = order.back().second;
      const Corner& before = outline[(i + outline.size() - 1) % outline.size()];
      const Corner& after = outline[(i + 1) % outline.size()];
      const bool touch = outline[i].same_place(from);
      const Corner& towards = touch ? holes[h][1] : from;
      if (!leads_inside(before, outline[i], after, towards)) continue;
      if (touch || is_clear(from, outline[i], outline, holes, h)) return i;
    }
    return std::nullopt;
  }

  bool is_clear(const Corner& a, const Corner& b, const std::vector<Corner>& outline,
                const std::vector<std::vector<Corner>>& holes, std::size_t first_hole) {
    const auto clear_of = [&](const std::vector<Corner>& loop) {
      if (!budget_.spend(loop.size())) return false;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (blocks(a, b, loop[i], loop[(i + 1) % loop.size()])) return false;
      }
      return true;
    };
    return clear_of(outline) && std::all_of(holes.begin() + static_cast<std::ptrdiff_t>(first_hole),
                                            holes.end(), clear_of);
  }

  /// Cuts ears off a joined outline until nothing is left.
  bool clip(const std::vector<Corner>& outline) {
    std::vector<std::size_t> next(outline.size());
    std::vector<std::size_t> before(outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
      next[i] = (i + 1) % outline.size();
      before[next[i]] = i;
    }
    CornerGrid grid(outline);
    std::size_t left = outline.size();
    std::size_t at = 0;
    std::size_t without_ear = 0;
    while (left > 2) {
      if (without_ear > left) {
        // Only what is too thin to tell left from right is in the way.
        const auto thinnest = thinnest_corner(outline, next, before, at, left);
        if (!thinnest) return false;
        at = *thinnest;
      }
      const Corner& a = outline[before[at]];
      const Corner& b = outline[at];
      const Corner& c = outline[next[at]];
      // There and back: nothing between.
      const bool forced = without_ear > left;
      const bool spike = a.same_place(c) || a.same_place(b) || b.same_place(c);
      if (!forced && !spike && !is_ear(outline, grid, before[at], at, next[at])) {
        at = next[at];
        ++without_ear;
        continue;
      }
      if (a.index != b.index && b.index != c.index && a.index != c.index) {
        triangles_.push_back({a.index, b.index, c.index});
      }
      grid.remove(at);
      next[before[at]] = next[at];
      before[next[at]] = before[at];
      // Not the neighbour: fans of narrow triangles would follow.
      at = spike ? before[at] : next[next[at]];
      --left;
      without_ear = 0;
    }
    return true;
  }

  /// The corner that is least far from the line between its neighbours, if that is near enough.
  std::optional<std::size_t> thinnest_corner(const std::vector<Corner>& outline,
                                             const std::vector<std::size_t>& next,
                                             const std::vector<std::size_t>& before, std::size_t at,
                                             std::size_t left) {
    if (thin_ == 0 || !budget_.spend(left)) return std::nullopt;
    std::optional<std::size_t> best;
    double least = 2 * thin_ * scale_;
    for (std::size_t n = 0; n < left; ++n, at = next[at]) {
      const Corner& a = outline[before[at]];
      const Corner& b = outline[at];
      const Corner& c = outline[next[at]];
      const double area = std::fabs(static_cast<double>(area2({a, b, c})));
      const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
      if (area < least * longest) {
        best = at;
        least = area / longest;
      }
    }
    return best;
  }

  bool is_ear(const std::vector<Corner>& outline, const CornerGrid& grid, std::size_t before,
              std::size_t at, std::size_t next) {
    const Corner& a = outline[before];
    const Corner& b = outline[at];
    const Corner& c = outline[next];
    if (side(a, b, c) <= 0 || !budget_.spend(1)) return false;
    return !grid.any_near(a, b, c, budget_, [&](std::size_t i) {
      const Corner& p = outline[i];
      if (p.same_place(a) || p.same_place(b) || p.same_place(c)) return false;
      return side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0;
    });
  }

  const std::vector<Vec3>& points_;
  WorkBudget& budget_;
  double thin_;
  int axis_ = 2;
  bool turned_ = false;
  double scale_ = 1;
  Vec3 low_ = Vec3::Constant(HUGE_VAL);
  Vec3 high_ = Vec3::Constant(-HUGE_VAL);
  std::vector<Loop> loops_;
  std::vector<Triangle> triangles_;
};

}  // namespace

Vec3 loop_normal(const std::vector<Vec3>& points, const Loop& loop) {
  Vec3 sum = Vec3::Zero();
  if (loop.empty()) return sum;
  const Vec3& origin = points[static_cast<std::size_t>(loop.front())];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 a = points[static_cast<std::size_t>(loop[i])] - origin;
    const Vec3 b = points[static_cast<std::size_t>(loop[(i + 1) % loop.size()])] - origin;
    sum += a.cross(b);
  }
  return sum;
}

std::optional<std::vector<Triangle>> triangulate(const std::vector<Vec3>& points,
                                                 const std::vector<Loop>& loops, const Vec3& normal,
                                                 WorkBudget& budget, double thin) {
  Cutter cutter(points, normal, budget, thin);
  for (const Loop& loop : loops) {
    if (!cutter.add(loop)) return std::nullopt;
  }
  return cutter.cut();
}

bool lines_cross(const std::vector<Vec3>& points, const std::vector<Loop>& loops,
                 const Vec3& normal, WorkBudget& budget) {
  Cutter cutter(points, normal, budget, 0);
  for (const Loop& loop : loops) {
    if (!cutter.add(loop)) return true;
  }
  return cutter.crosses();
}

}  // namespace rubicon::ifc
