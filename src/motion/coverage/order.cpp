#include "src/motion/coverage/order.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "src/motion/coverage/tour.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

constexpr double kFar = 1e15;           ///< units; in place of "no way"
constexpr std::size_t kMostExact = 12;  ///< cells
constexpr std::size_t kCorners = 4;     ///< where a cell may be begun

class LineOrderer {
 public:
  explicit LineOrderer(const OrderQuery& query) : query_(query), lines_(*query.lines) {}

  OrderResult run() {
    drop_cut_off();
    if (kept_.empty()) return std::move(result_);
    make_cells();
    const std::vector<std::size_t> order = order_cells();
    const std::vector<std::size_t> corners = choose_corners(order);
    for (std::size_t i = 0; i < order.size(); ++i) {
      result_.cells.push_back(cells_[order[i]].number);
      const auto& lines = cells_[order[i]].ways[corners[i]];
      result_.lines.insert(result_.lines.end(), lines.begin(), lines.end());
    }
    improve_lines();
    return std::move(result_);
  }

 private:
  struct CellToOrder {
    int number = 0;
    std::array<std::vector<DirectedLine>, kCorners> ways;  ///< to and fro from each corner
    Point middle;
  };

  const Point& end_point(int end) const {
    const std::vector<Point>& points = lines_[at(end / 2)].points;
    return end % 2 == 0 ? points.front() : points.back();
  }
  double between(int a, int b) { return between_within(a, b, kFar); }
  /// The shortest way between two ends where it is `limit` or less, else anything more.
  double between_within(int a, int b, double limit) {
    if (a > b) std::swap(a, b);
    const auto key = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b);
    KnownLength& known = lengths_[key];
    if (known.is_exact) return known.length;
    if (limit <= known.length) return std::max(known.length, std::nextafter(limit, 2 * kFar));
    const double length =
        limit < kFar ? query_.space->shortest_length_within(end_point(a), end_point(b), limit)
                     : std::min(query_.space->shortest_length(end_point(a), end_point(b)), kFar);
    known.is_exact = length <= limit;
    known.length = known.is_exact ? length : limit;
    return length;
  }
  double from_start(int end) {
    if (!start_) return 0;
    const auto [found, is_new] = start_lengths_.try_emplace(end, 0.0);
    if (is_new) {
      found->second = std::min(query_.space->shortest_length(*start_, end_point(end)), kFar);
    }
    return found->second;
  }

  /// Of the lines that were seen the one that begins nearest to a place, -1 if none was.
  int nearest_seen(const Buckets& seen, const Point& p, const Box& box) const {
    const std::int64_t whole = box.width() + box.height() + 1;
    const auto share = static_cast<std::int64_t>(std::sqrt(static_cast<double>(lines_.size()))) + 1;
    for (std::int64_t reach = whole / share + 1;; reach *= 4) {
      int nearest = -1;
      double least = kFar;
      seen.any_in({{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}}, [&](int line) {
        const double far = distance(p, lines_[at(line)].points.front());
        if (far < least || (far == least && line < nearest)) {
          least = far;
          nearest = line;
        }
        return false;
      });
      if (nearest >= 0 || reach > whole) return nearest;
    }
  }

  /// Keeps the lines that are reached from the start, or else the most that reach each other.
  void drop_cut_off() {
    std::vector<std::vector<int>> parts;
    std::vector<std::size_t> part_of(lines_.size());
    const auto reaches = [&](const Point& p, int line) {
      return query_.space->reaches(p, lines_[at(line)].points.front());
    };
    Box box = box_of(lines_[0].points.front(), lines_[0].points.front());
    for (const WorkLine& line : lines_) {
      const Point& p = line.points.front();
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    Buckets seen(box, lines_.size());
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const Point& p = lines_[i].points.front();
      // Ways to near lines are found soon. Else the search ends soon where it begins in a small
      // part, so it begins at the new line; the largest part stands first.
      const int near = nearest_seen(seen, p, box);
      std::size_t home = parts.size();
      if (near >= 0 && reaches(p, near)) {
        home = part_of[at(near)];
      } else {
        home = 0;
        while (home < parts.size() && !reaches(p, parts[home].back())) ++home;
      }
      if (home == parts.size()) parts.emplace_back();
      parts[home].push_back(static_cast<int>(i));
      part_of[i] = home;
      seen.add(static_cast<int>(i), p, p);
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    double most = -1;
    for (const std::vector<int>& part : parts) {
      double length = 0;
      for (const int line : part) {
        length += distance(lines_[at(line)].points.front(), lines_[at(line)].points.back());
      }
      const Point& p = lines_[at(part.front())].points.front();
      if (query_.from && query_.space->reaches(*query_.from, p)) {
        length = kFar;
      }
      if (length <= most) continue;
      most = length;
      kept_ = part;
    }
    result_.cut_off = static_cast<int>(lines_.size() - kept_.size());
  }

  void make_cells() {
    std::vector<std::vector<int>> of_cell(query_.cell_count);
    for (const int line : kept_) of_cell[at(lines_[at(line)].cell)].push_back(line);
    for (std::size_t i = 0; i < of_cell.size(); ++i) {
      if (of_cell[i].empty()) continue;
      CellToOrder cell;
      cell.number = static_cast<int>(i);
      for (std::size_t corner = 0; corner < kCorners; ++corner) {
        cell.ways[corner] = to_and_fro(of_cell[i], (corner & 1) != 0, (corner & 2) != 0);
      }
      Box box = box_of(end_point(2 * of_cell[i][0]), end_point(2 * of_cell[i][0] + 1));
      for (const int line : of_cell[i]) {
        for (const Point& p : lines_[at(line)].points) {
          box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
          box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
        }
      }
      cell.middle = {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
      cells_.push_back(std::move(cell));
    }
    start_ = query_.from;
    if (start_ || !query_.inlet) return;
    for (std::size_t i = 1; i < cells_.size(); ++i) {
      if (distance(cells_[i].middle, *query_.inlet) >
          distance(cells_[first_cell_].middle, *query_.inlet)) {
        first_cell_ = i;
      }
    }
    has_first_ = true;
    const auto& lines = cells_[first_cell_].ways[0];
    start_ = end_point(2 * lines[0].line);
    for (const DirectedLine& line : lines) {
      for (const int side : {0, 1}) {
        const Point& p = end_point(2 * line.line + side);
        if (distance(p, *query_.inlet) > distance(*start_, *query_.inlet)) start_ = p;
      }
    }
  }

  std::vector<DirectedLine> to_and_fro(std::vector<int> lines, bool downwards, bool leftwards) {
    const auto first_pass = std::stable_partition(
        lines.begin(), lines.end(), [&](int line) { return !lines_[at(line)].is_pass; });
    std::vector<DirectedLine> result;
    std::vector<std::vector<int>> rows;
    for (auto it = lines.begin(); it != first_pass; ++it) {
      const std::int64_t y = lines_[at(*it)].points[0].y;
      if (rows.empty() || lines_[at(rows.back()[0])].points[0].y != y) rows.emplace_back();
      rows.back().push_back(*it);
    }
    if (downwards) std::reverse(rows.begin(), rows.end());
    for (std::vector<int>& row : rows) {
      if (leftwards) std::reverse(row.begin(), row.end());
      for (const int line : row) result.push_back({line, leftwards});
      leftwards = !leftwards;
    }
    for (auto it = first_pass; it != lines.end(); ++it) result.push_back({*it, false});
    return result;
  }

  static int first_end(const std::vector<DirectedLine>& way) {
    return 2 * way.front().line + (way.front().reversed ? 1 : 0);
  }
  static int last_end(const std::vector<DirectedLine>& way) {
    return 2 * way.back().line + (way.back().reversed ? 0 : 1);
  }

  std::vector<std::size_t> order_cells() {
    const bool exact = query_.rule == OrderRule::kExact ||
                       (query_.rule == OrderRule::kAuto && cells_.size() <= kMostExact);
    return exact && cells_.size() <= kMostExact ? exact_order() : near_order();
  }

  std::vector<std::size_t> exact_order() {
    const std::size_t count = cells_.size();
    const std::size_t states = count * kCorners;
    std::vector<double> step(states * states);
    for (std::size_t a = 0; a < states; ++a) {
      for (std::size_t b = 0; b < states; ++b) {
        if (a / kCorners == b / kCorners) continue;
        step[a * states + b] = between(last_end(cells_[a / kCorners].ways[a % kCorners]),
                                       first_end(cells_[b / kCorners].ways[b % kCorners]));
      }
    }
    const std::size_t sets = std::size_t{1} << count;
    std::vector<double> cost(sets * states, std::numeric_limits<double>::infinity());
    std::vector<int> before(sets * states, -1);
    for (std::size_t s = 0; s < states; ++s) {
      if (has_first_ && s / kCorners != first_cell_) continue;
      cost[(std::size_t{1} << (s / kCorners)) * states + s] =
          from_start(first_end(cells_[s / kCorners].ways[s % kCorners]));
    }
    for (std::size_t set = 1; set < sets; ++set) {
      for (std::size_t a = 0; a < states; ++a) {
        const double so_far = cost[set * states + a];
        if (!std::isfinite(so_far)) continue;
        for (std::size_t b = 0; b < states; ++b) {
          const std::size_t bit = std::size_t{1} << (b / kCorners);
          if ((set & bit) != 0) continue;
          const std::size_t to = (set | bit) * states + b;
          if (so_far + step[a * states + b] >= cost[to]) continue;
          cost[to] = so_far + step[a * states + b];
          before[to] = static_cast<int>(a);
        }
      }
    }
    std::size_t set = sets - 1;
    std::size_t last = 0;
    for (std::size_t s = 1; s < states; ++s) {
      if (cost[set * states + s] < cost[set * states + last]) last = s;
    }
    std::vector<std::size_t> order;
    for (int s = static_cast<int>(last); s >= 0;) {
      order.push_back(at(s) / kCorners);
      const int previous = before[set * states + at(s)];
      set &= ~(std::size_t{1} << (at(s) / kCorners));
      s = previous;
    }
    std::reverse(order.begin(), order.end());
    return order;
  }

  std::vector<std::size_t> near_order() {
    // Bottom up in strips is a fair beginning; moves do the rest.
    std::vector<DirectedLine> order;
    for (std::size_t i = 0; i < cells_.size(); ++i) order.push_back({static_cast<int>(i), false});
    std::sort(order.begin(), order.end(), [&](const DirectedLine& a, const DirectedLine& b) {
      const Point& p = cells_[at(a.line)].middle;
      const Point& q = cells_[at(b.line)].middle;
      return std::pair(p.y, p.x) < std::pair(q.y, q.x);
    });
    if (has_first_) {
      const auto first = std::find_if(order.begin(), order.end(), [&](const DirectedLine& item) {
        return at(item.line) == first_cell_;
      });
      std::rotate(order.begin(), first, first + 1);
    }
    TourQuery tour;
    for (const CellToOrder& cell : cells_) tour.ends.insert(tour.ends.end(), 2, cell.middle);
    tour.between = [&](int a, int b) { return distance(tour.ends[at(a)], tour.ends[at(b)]); };
    if (start_) tour.from_start = [&](int end) { return distance(*start_, tour.ends[at(end)]); };
    improve_tour(tour, order);
    std::vector<std::size_t> result;
    for (const DirectedLine& item : order) result.push_back(at(item.line));
    return result;
  }

  /// The corners to begin the cells at, for the shortest way in this order.
  std::vector<std::size_t> choose_corners(const std::vector<std::size_t>& order) {
    std::vector<std::array<double, kCorners>> cost(order.size());
    std::vector<std::array<std::size_t, kCorners>> before(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t b = 0; b < kCorners; ++b) {
        const int end = first_end(cells_[order[i]].ways[b]);
        if (i == 0) {
          cost[i][b] = from_start(end);
          continue;
        }
        cost[i][b] = std::numeric_limits<double>::infinity();
        for (std::size_t a = 0; a < kCorners; ++a) {
          const double through =
              cost[i - 1][a] + between(last_end(cells_[order[i - 1]].ways[a]), end);
          if (through >= cost[i][b]) continue;
          cost[i][b] = through;
          before[i][b] = a;
        }
      }
    }
    std::vector<std::size_t> result(order.size());
    const auto& last = cost.back();
    std::size_t corner =
        static_cast<std::size_t>(std::min_element(last.begin(), last.end()) - last.begin());
    for (std::size_t i = order.size(); i-- > 0;) {
      result[i] = corner;
      corner = before[i][corner];
    }
    return result;
  }

  void improve_lines() {
    TourQuery tour;
    for (std::size_t i = 0; i < 2 * lines_.size(); ++i) {
      tour.ends.push_back(end_point(static_cast<int>(i)));
    }
    if (query_.whole_cells) {
      for (const WorkLine& line : lines_) tour.groups.push_back(line.cell);
    }
    tour.between = [&](int a, int b) { return between(a, b); };
    tour.between_within = [&](int a, int b, double limit) { return between_within(a, b, limit); };
    if (start_) tour.from_start = [&](int end) { return from_start(end); };
    tour.kicks = kept_.size() <= kMostLinesForTries ? query_.tries : 0;
    improve_tour(tour, result_.lines);
  }

  const OrderQuery& query_;
  const std::vector<WorkLine>& lines_;
  std::vector<int> kept_;
  std::vector<CellToOrder> cells_;
  std::size_t first_cell_ = 0;
  bool has_first_ = false;
  std::optional<Point> start_;
  /// Of a shortest way, or what it is longer than.
  struct KnownLength {
    double length = -1;
    bool is_exact = false;
  };
  std::unordered_map<std::uint64_t, KnownLength> lengths_;
  std::unordered_map<int, double> start_lengths_;
  OrderResult result_;
};

}  // namespace

OrderResult order_lines(const OrderQuery& query) {
  return query.lines->empty() ? OrderResult{} : LineOrderer(query).run();
}

}  // namespace rubicon::coverage
