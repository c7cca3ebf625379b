#include "src/exchange/area_io/line_work.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "src/motion/coverage/region.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::area_io {

namespace {

using coverage::Box;
using coverage::Buckets;
using math::at;

/// Corners by place: those within the tolerance of one are it.
class Corners {
 public:
  explicit Corners(std::int64_t tolerance) : tolerance_(tolerance) {}

  /// The nearest corner within the tolerance, -1: none.
  int find(const Point& p) const {
    int best = -1;
    double best_distance = static_cast<double>(tolerance_) + 1e-9;
    const auto [column, row] = cell_of(p);
    for (std::int64_t i = column - 1; i <= column + 1; ++i) {
      for (std::int64_t k = row - 1; k <= row + 1; ++k) {
        const auto found = cells_.find({i, k});
        if (found == cells_.end()) continue;
        for (const int each : found->second) {
          const double off = coverage::distance(points[at(each)], p);
          if (off > best_distance || (off == best_distance && each > best && best >= 0)) continue;
          best_distance = off;
          best = each;
        }
      }
    }
    return best;
  }
  int find_or_add(const Point& p) {
    const int found = find(p);
    if (found >= 0) return found;
    points.push_back(p);
    const int index = static_cast<int>(points.size()) - 1;
    cells_[cell_of(p)].push_back(index);
    return index;
  }

  std::vector<Point> points;

 private:
  std::pair<std::int64_t, std::int64_t> cell_of(const Point& p) const {
    const auto down = [this](std::int64_t value) {
      const std::int64_t pitch = tolerance_ + 1;
      return value >= 0 ? value / pitch : -((-value + pitch - 1) / pitch);
    };
    return {down(p.x), down(p.y)};
  }

  std::int64_t tolerance_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<int>> cells_;
};

/// Corners that share a coordinate because lines along an axis run through them.
class SharedCoordinate {
 public:
  explicit SharedCoordinate(std::size_t count) : above_(count), best_(count) {
    std::iota(above_.begin(), above_.end(), 0);
  }
  /// The piece between a and b has this coordinate; the longest piece decides, of equals the first.
  void join(int a, int b, std::int64_t coordinate, std::int64_t length) {
    const int first = root(a);
    const int second = root(b);
    Best best = better(best_[at(first)], best_[at(second)]);
    best = better(best, {length, coordinate});
    above_[at(second)] = first;
    best_[at(first)] = best;
  }
  std::optional<std::int64_t> of(int corner) {
    const Best& best = best_[at(root(corner))];
    if (best.length < 0) return std::nullopt;
    return best.coordinate;
  }

 private:
  struct Best {
    std::int64_t length = -1;
    std::int64_t coordinate = 0;
  };
  static Best better(const Best& a, const Best& b) { return b.length > a.length ? b : a; }
  int root(int corner) {
    while (above_[at(corner)] != corner) {
      above_[at(corner)] = above_[at(above_[at(corner)])];
      corner = above_[at(corner)];
    }
    return corner;
  }
  std::vector<int> above_;
  std::vector<Best> best_;
};

/// Whether direction a comes before b, counted from x counter-clockwise.
bool turns_before(const Point& a, const Point& b) {
  const auto upper = [](const Point& d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
  if (upper(a) != upper(b)) return upper(a);
  return a.x * b.y - a.y * b.x > 0;
}

class LineCloser {
 public:
  LineCloser(const std::vector<DrawnPiece>& pieces, std::int64_t tolerance)
      : pieces_(pieces), tolerance_(tolerance), corners_(tolerance) {}

  ClosedLines run() {
    if (pieces_.empty()) return {};
    join_ends();
    add_crossings();
    if (result_.too_tangled) return std::move(result_);
    cut_at_corners();
    if (result_.too_tangled) return std::move(result_);
    straighten();
    find_open_ends();
    walk_borders();
    return std::move(result_);
  }

 private:
  struct Edge {
    int a, b;
    std::size_t piece;
    friend bool operator<(const Edge& l, const Edge& r) {
      return std::tie(l.a, l.b) < std::tie(r.a, r.b);
    }
  };

  void join_ends() {
    for (const DrawnPiece& piece : pieces_) {
      for (const Point& end : {piece.from, piece.to}) {
        const int corner = corners_.find_or_add(end);
        if (corners_.points[at(corner)] != end) moved_.insert({end.x, end.y});
        ends_.push_back(corner);
      }
    }
  }

  Box everywhere() const {
    Box box{pieces_.front().from, pieces_.front().from};
    for (const DrawnPiece& piece : pieces_) {
      for (const Point& p : {piece.from, piece.to}) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
      }
    }
    return box;
  }

  void add_crossings() {
    buckets_.emplace(everywhere(), pieces_.size());
    std::size_t looked = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Point& a = pieces_[i].from;
      const Point& b = pieces_[i].to;
      std::set<int> seen;
      buckets_->any_near(a, b, [&](int item) {
        const DrawnPiece& other = pieces_[at(item)];
        if (++looked > 100 * kMostCrossings) return true;
        if (!coverage::segments_cross(a, b, other.from, other.to)) return false;
        if (seen.insert(item).second) add_crossing(a, b, other);
        return result_.too_tangled;
      });
      if (looked > 100 * kMostCrossings) result_.too_tangled = true;
      if (result_.too_tangled) return;
      buckets_->add(static_cast<int>(i), a, b);
    }
  }

  void add_crossing(const Point& a, const Point& b, const DrawnPiece& other) {
    if (++crossings_ > kMostCrossings) result_.too_tangled = true;
    const auto left = static_cast<double>(coverage::cross(a, b, other.from));
    const auto right = static_cast<double>(coverage::cross(a, b, other.to));
    const double share = left / (left - right);
    const auto between = [&](std::int64_t from, std::int64_t to) {
      return from + std::llround(share * static_cast<double>(to - from));
    };
    corners_.find_or_add({between(other.from.x, other.to.x), between(other.from.y, other.to.y)});
  }

  /// Which corners lie on which pieces.
  void cut_at_corners() {
    std::vector<std::vector<std::pair<double, int>>> on(pieces_.size());
    std::size_t count = 0;
    for (std::size_t c = 0; c < corners_.points.size() && !result_.too_tangled; ++c) {
      const Point& p = corners_.points[c];
      const Box around{{p.x - tolerance_, p.y - tolerance_}, {p.x + tolerance_, p.y + tolerance_}};
      std::set<int> seen;
      buckets_->any_in(around, [&](int item) {
        if (!seen.insert(item).second) return false;
        const auto share = share_on(at(item), static_cast<int>(c));
        if (!share) return false;
        on[at(item)].emplace_back(*share, static_cast<int>(c));
        result_.too_tangled = ++count > 2 * kMostCrossings;
        return result_.too_tangled;
      });
    }
    if (result_.too_tangled) return;
    std::set<Edge> edges;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      std::sort(on[i].begin(), on[i].end());
      int before = ends_[2 * i];
      on[i].emplace_back(2.0, ends_[2 * i + 1]);
      for (const auto& [share, corner] : on[i]) {
        if (corner == before) continue;
        const bool is_new =
            edges.insert({std::min(before, corner), std::max(before, corner), i}).second;
        if (!is_new) ++result_.overlaps;
        before = corner;
      }
    }
    edges_.assign(edges.begin(), edges.end());
  }

  /// How far along a piece a corner lies that is not its end; nothing if it does not lie on it.
  std::optional<double> share_on(std::size_t i, int corner) {
    if (corner == ends_[2 * i] || corner == ends_[2 * i + 1]) return std::nullopt;
    const Point& a = pieces_[i].from;
    const Point& b = pieces_[i].to;
    const Point& p = corners_.points[at(corner)];
    const double length = coverage::distance(a, b);
    if (length == 0) return std::nullopt;
    const double along = static_cast<double>(coverage::dot(a, b, p)) / length;
    const double off = std::abs(static_cast<double>(coverage::cross(a, b, p))) / length;
    if (along <= 0 || along >= length || off > static_cast<double>(tolerance_)) return std::nullopt;
    if (off > 1) moved_.insert({p.x, p.y});
    return along / length;
  }

  /// What was drawn along an axis lies along it, whatever its ends were joined to.
  void straighten() {
    SharedCoordinate x(corners_.points.size());
    SharedCoordinate y(corners_.points.size());
    for (const Edge& edge : edges_) {
      const DrawnPiece& piece = pieces_[edge.piece];
      const std::int64_t wide = std::abs(piece.to.x - piece.from.x);
      const std::int64_t high = std::abs(piece.to.y - piece.from.y);
      if (wide <= 1 && high > 1) x.join(edge.a, edge.b, piece.from.x, high);
      if (high <= 1 && wide > 1) y.join(edge.a, edge.b, piece.from.y, wide);
    }
    for (std::size_t c = 0; c < corners_.points.size(); ++c) {
      Point& p = corners_.points[c];
      p = {x.of(static_cast<int>(c)).value_or(p.x), y.of(static_cast<int>(c)).value_or(p.y)};
    }
    result_.closed_gaps = static_cast<int>(moved_.size());
    // Straightening may have laid corners onto each other.
    std::map<Point, int> first;
    std::vector<int> same(corners_.points.size());
    for (std::size_t c = 0; c < same.size(); ++c) {
      same[c] = first.emplace(corners_.points[c], static_cast<int>(c)).first->second;
    }
    std::set<Edge> edges;
    for (const Edge& edge : edges_) {
      const int a = same[at(edge.a)];
      const int b = same[at(edge.b)];
      if (a != b) edges.insert({std::min(a, b), std::max(a, b), edge.piece});
    }
    edges_.assign(edges.begin(), edges.end());
    beside_.resize(corners_.points.size());
    for (const Edge& edge : edges_) {
      beside_[at(edge.a)].emplace_back(edge.b, edge.piece);
      beside_[at(edge.b)].emplace_back(edge.a, edge.piece);
    }
  }

  void find_open_ends() {
    for (std::size_t c = 0; c < beside_.size(); ++c) {
      if (beside_[c].size() != 1) continue;
      OpenEnd end;
      end.at = corners_.points[c];
      end.line = pieces_[beside_[c].front().second].line;
      result_.open.push_back(end);
    }
    // Each is named with the nearest other; of many only the first.
    constexpr std::size_t kCompared = 2000;
    const std::size_t count = std::min(result_.open.size(), kCompared);
    for (std::size_t i = 0; i < count; ++i) {
      OpenEnd& end = result_.open[i];
      double best = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const OpenEnd& other = result_.open[k];
        const double off = coverage::distance(end.at, other.at);
        if (k == i || (end.has_other && off >= best)) continue;
        best = off;
        end.has_other = true;
        end.other = other.at;
        end.other_line = other.line;
      }
    }
  }

  Point way(int from, int to) const {
    const Point& a = corners_.points[at(from)];
    const Point& b = corners_.points[at(to)];
    return {b.x - a.x, b.y - a.y};
  }

  /// Once round each group of edges that hang together, with what is outside on the right.
  void walk_borders() {
    std::vector<int> order(corners_.points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      return std::tie(corners_.points[at(a)], a) < std::tie(corners_.points[at(b)], b);
    });
    for (auto& all : beside_) {
      const int here = static_cast<int>(&all - beside_.data());
      std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) {
        return turns_before(way(here, a.first), way(here, b.first));
      });
    }
    std::vector<bool> seen(corners_.points.size(), false);
    for (const int start : order) {
      if (seen[at(start)] || beside_[at(start)].size() < 2) continue;
      mark(start, seen);
      const Ring walk = border_from(start);
      for (coverage::Region& region : coverage::united({walk})) {
        result_.rings.push_back(std::move(region.outline));
      }
    }
  }

  void mark(int start, std::vector<bool>& seen) const {
    std::vector<int> open{start};
    seen[at(start)] = true;
    while (!open.empty()) {
      const int here = open.back();
      open.pop_back();
      for (const auto& [next, piece] : beside_[at(here)]) {
        if (seen[at(next)]) continue;
        seen[at(next)] = true;
        open.push_back(next);
      }
    }
  }

  /// The first edge counter-clockwise behind a direction.
  int next_after(int here, const Point& direction) const {
    const auto& all = beside_[at(here)];
    for (const auto& [next, piece] : all) {
      if (turns_before(direction, way(here, next))) return next;
    }
    return all.front().first;
  }

  Ring border_from(int start) const {
    // From its least corner, where all else lies to the right: first what is lowest.
    const int first = next_after(start, {0, -1});
    Ring ring;
    int before = start;
    int here = first;
    std::size_t left = 4 * edges_.size() + 4;
    ring.push_back(corners_.points[at(start)]);
    while (left-- > 0) {
      const int next = next_after(here, way(here, before));
      if (here == start && next == first) break;
      ring.push_back(corners_.points[at(here)]);
      before = here;
      here = next;
    }
    return ring;
  }

  const std::vector<DrawnPiece>& pieces_;
  const std::int64_t tolerance_;
  Corners corners_;
  std::vector<int> ends_;  ///< corners: two of each piece
  std::optional<Buckets> buckets_;
  std::size_t crossings_ = 0;
  std::set<std::pair<std::int64_t, std::int64_t>> moved_;
  std::vector<Edge> edges_;
  std::vector<std::vector<std::pair<int, std::size_t>>> beside_;  ///< by corner: others, piece
  ClosedLines result_;
};

}  // namespace

ClosedLines close_lines(const std::vector<DrawnPiece>& pieces, std::int64_t tolerance) {
  return LineCloser(pieces, std::max<std::int64_t>(tolerance, 1)).run();
}

}  // namespace rubicon::area_io
