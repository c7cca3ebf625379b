#include "src/motion/coverage/turning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "src/motion/coverage/tour.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

/// Units, in place of "no way": dearer than any order of allowed ways.
constexpr double kNoTurn = 1e12;
/// Units: ends of lines are found to 1 mm.
constexpr std::int64_t kEndPitch = kUnitsPerMetre / 1000;
/// Shorter lines are not worth their turns, as a share of the width.
constexpr double kShortestLine = 0.25;
/// Of one front; more is no front.
constexpr int kMostFrontPasses = 1000;
/// Units between the places of a slanted line that are looked at.
constexpr double kFreePitch = 0.05 * static_cast<double>(kUnitsPerMetre);
/// Degrees between the headings in which a machine may begin at a given place.
constexpr int kStartPitch_deg = 10;

double direction_deg(const Point& a, const Point& b) {
  return math::atan2_deg(static_cast<double>(b.y - a.y), static_cast<double>(b.x - a.x));
}

/// The place on the line from a to b so far from a, in units.
Point on_line(const Point& a, const Point& b, std::int64_t along) {
  const double share = static_cast<double>(along) / distance(a, b);
  const auto part = [&](std::int64_t from, std::int64_t to) {
    const double value = static_cast<double>(to - from) * share;
    return from + static_cast<std::int64_t>(value < 0 ? value - 0.5 : value + 0.5);
  };
  return {part(a.x, b.x), part(a.y, b.y)};
}

/// Where the machine may drive.
class TurningFloor {
 public:
  TurningFloor(const FreeSpace& space, double radius) : space_(space), radius_(radius) {}

  bool is_free(const std::vector<Heading>& corners) const {
    Point before = snap(corners.front().place);
    if (!space_.allows(before)) return false;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Point next = snap(corners[i].place);
      if (!space_.allows(next) || !space_.sees(before, next)) return false;
      before = next;
    }
    return true;
  }

  /// The shortest word that stays on the floor.
  std::optional<DubinsWay> best_way(const Heading& from, const Heading& to) const {
    for (const DubinsWay& way : dubins_ways(from, to, radius_)) {
      if (is_free(way.corners(kTurnStep_deg))) return way;
    }
    return std::nullopt;
  }

  /// To how many sides a quarter of a circle leads away from p.
  int sides_to_turn(const Point& p, double heading_deg) const {
    DubinsWay arc;
    arc.from = {metres(p), heading_deg};
    arc.radius = radius_;
    int sides = 0;
    for (const double quarter : {90.0, -90.0}) {
      arc.turned_deg = {quarter, 0, 0};
      sides += is_free(arc.corners(kTurnStep_deg)) ? 1 : 0;
    }
    return sides;
  }

  /// How far the line from a to b is cut back at b, in units; its length where nothing is left. To
  /// where the machine can turn to either side, if that is less than a radius from where it can
  /// turn to one.
  std::int64_t cut_back(const Point& a, const Point& b) const {
    const auto length = static_cast<std::int64_t>(distance(a, b));
    const std::int64_t one = cut_back(a, b, 0, length, 1);
    if (one >= length) return length;
    const std::int64_t most = std::min(length, one + in_units(radius_));
    const std::int64_t both = cut_back(a, b, one, most, 2);
    return both < most ? both : one;
  }

 private:
  /// From `least` on the first place from which so many sides are free; `most` if there is none.
  std::int64_t cut_back(const Point& a, const Point& b, std::int64_t least, std::int64_t most,
                        int sides) const {
    const auto length = static_cast<std::int64_t>(distance(a, b));
    const double heading = direction_deg(a, b);
    const auto fits = [&](std::int64_t cut) {
      return sides_to_turn(cut == 0 ? b : on_line(a, b, length - cut), heading) >= sides;
    };
    if (fits(least)) return least;
    const std::int64_t pitch = std::max<std::int64_t>(in_units(radius_ / 8), kEndPitch);
    std::int64_t high = least + pitch;
    while (high < most && !fits(high)) high += pitch;
    if (high >= most) return most;
    std::int64_t low = high - pitch;
    while (high - low > kEndPitch) {
      const std::int64_t middle = (low + high) / 2;
      (fits(middle) ? high : low) = middle;
    }
    return high;
  }

  const FreeSpace& space_;
  double radius_;
};

/// A line with the ends that it had before it was cut back.
struct CutLine {
  WorkLine line;
  Point whole_begin, whole_end;
  std::int64_t cut_begin = 0, cut_end = 0;
};

class TurningPlanner {
 public:
  explicit TurningPlanner(const TurningQuery& query)
      : query_(query), floor_(*query.space, query.radius) {}

  TurningResult run() {
    for (const WorkLine& line : *query_.lines) {
      for (std::size_t i = 1; i < line.points.size(); ++i) {
        add_line({{line.points[i - 1], line.points[i]}, line.cell, line.is_pass}, true);
      }
    }
    add_fronts();
    if (lines_.empty()) return {};
    order_lines_by_turns();
    drive();
    return std::move(result_);
  }

 private:
  void add_line(WorkLine line, bool counts) {
    CutLine cut;
    cut.whole_begin = line.points.front();
    cut.whole_end = line.points.back();
    const auto length = static_cast<std::int64_t>(distance(cut.whole_begin, cut.whole_end));
    cut.cut_end = floor_.cut_back(cut.whole_begin, cut.whole_end);
    cut.cut_begin = floor_.cut_back(cut.whole_end, cut.whole_begin);
    const auto shortest =
        static_cast<std::int64_t>(kShortestLine * static_cast<double>(query_.width));
    const std::int64_t left = length - cut.cut_begin - cut.cut_end;
    const bool is_short = left < std::min(shortest, length);
    if (left > 0 && !is_short) {
      if (cut.cut_begin > 0) {
        line.points.front() = on_line(cut.whole_begin, cut.whole_end, cut.cut_begin);
      }
      if (cut.cut_end > 0)
        line.points.back() = on_line(cut.whole_end, cut.whole_begin, cut.cut_end);
    }
    const bool drives = left > 0 && !is_short && query_.space->allows(line.points.front()) &&
                        query_.space->allows(line.points.back()) &&
                        query_.space->sees(line.points.front(), line.points.back());
    if (!drives) {
      if (counts) ++result_.cut_off;
      return;
    }
    cut.line = std::move(line);
    lines_.push_back(std::move(cut));
  }

  /// Ends of lines that were cut back side by side at one wall: across the lines, or along a
  /// slanted edge of their cell.
  struct Front {
    int cell;
    bool at_right;    ///< end of the lines with the larger x
    Point low, high;  ///< of the edge; of a wall across the lines they have one x
    bool is_slanted;
    std::vector<std::pair<std::int64_t, std::int64_t>> ends;  ///< y, how far it is cut back
  };

  /// The slanted edge of a cell that a line ends at, if it ends at one.
  const Side* slanted_edge_at(const Cell& cell, const Point& end, bool at_right) const {
    for (const Side& side : at_right ? cell.right : cell.left) {
      if (side.low.x == side.high.x || end.y < side.low.y || end.y > side.high.y) continue;
      const std::int64_t off = at_right ? side.x_below(end.y) : side.x_above(end.y);
      if (std::abs(off - end.x) <= 2) return &side;
    }
    return nullptr;
  }

  std::vector<Front> fronts() const {
    std::vector<Front> all;
    for (const CutLine& cut : lines_) {
      if (cut.line.is_pass) continue;
      for (const bool at_end : {false, true}) {
        const std::int64_t back = at_end ? cut.cut_end : cut.cut_begin;
        if (back == 0) continue;
        const Point& whole = at_end ? cut.whole_end : cut.whole_begin;
        const bool at_right = at_end == (cut.whole_end.x > cut.whole_begin.x);
        const Side* const edge =
            slanted_edge_at((*query_.cells)[at(cut.line.cell)], whole, at_right);
        const Point low = edge != nullptr ? edge->low : whole;
        const auto found = std::find_if(all.begin(), all.end(), [&](const Front& each) {
          return each.cell == cut.line.cell && each.at_right == at_right &&
                 each.is_slanted == (edge != nullptr) &&
                 (edge != nullptr ? each.low == low : each.low.x == whole.x) &&
                 std::abs(each.ends.back().first - whole.y) * 2 <= 3 * query_.width;
        });
        if (found == all.end()) {
          all.push_back({cut.line.cell,
                         at_right,
                         low,
                         edge != nullptr ? edge->high : whole,
                         edge != nullptr,
                         {{whole.y, back}}});
        } else {
          found->ends.emplace_back(whole.y, back);
        }
      }
    }
    return all;
  }

  /// Lines across those that were cut back side by side along a front wider than two radii.
  void add_fronts() {
    for (const Front& front : fronts()) {
      const Cell& cell = (*query_.cells)[at(front.cell)];
      std::int64_t low = front.ends.front().first;
      std::int64_t high = low;
      std::int64_t depth = 0;
      for (const auto& [y, back] : front.ends) {
        low = std::min(low, y);
        high = std::max(high, y);
        depth = std::max(depth, back);
      }
      low = std::max(low - query_.width / 2, cell.bottom);
      high = std::min(high + query_.width / 2, cell.top);
      if (front.is_slanted) {
        add_slanted_front(front, std::max(low, front.low.y), std::min(high, front.high.y), depth);
      } else if (in_metres(high - low) >= 2 * query_.radius) {
        add_straight_front(front, low, high, depth);
      }
    }
  }

  void add_straight_front(const Front& front, std::int64_t low, std::int64_t high,
                          std::int64_t depth) {
    const std::int64_t passes = (depth + query_.width - 1) / query_.width;
    const std::int64_t inwards = front.at_right ? -1 : 1;
    for (std::int64_t k = 0; k < passes; ++k) {
      const std::int64_t x = front.low.x + inwards * (depth * (2 * k + 1) / (2 * passes));
      for (const Stretch& stretch : query_.space->stretches_along_y(x, low, high)) {
        if (stretch.low >= stretch.high) continue;
        add_line({{{x, stretch.low}, {x, stretch.high}}, front.cell, true}, false);
      }
    }
  }

  /// Along the edge; what is next to it is worked by the pass that runs on it.
  void add_slanted_front(const Front& front, std::int64_t low, std::int64_t high,
                         std::int64_t depth) {
    const double length = distance(front.low, front.high);
    const double along_x = static_cast<double>(front.high.x - front.low.x) / length;
    const double along_y = static_cast<double>(front.high.y - front.low.y) / length;
    const double inwards = front.at_right ? -1 : 1;
    const double half = 0.5 * static_cast<double>(query_.width);
    // The depth is counted along the lines; across the edge it is less.
    const double deep = static_cast<double>(depth) * along_y - half;
    const double wide = static_cast<double>(high - low) / along_y;
    if (!(deep > 0) || wide < 2 * query_.radius * static_cast<double>(kUnitsPerMetre)) return;
    const double count = std::ceil(deep / (2 * half));
    const auto passes = static_cast<int>(std::min(count, static_cast<double>(kMostFrontPasses)));
    for (int k = 0; k < passes; ++k) {
      const double off = half + deep * (2 * k + 1) / (2 * passes);
      const auto place = [&](std::int64_t y) {
        const double share = static_cast<double>(y - front.low.y) / along_y;
        const double x = static_cast<double>(front.low.x) + share * along_x;
        return Point{static_cast<std::int64_t>(std::floor(x + inwards * off * along_y + 0.5)),
                     static_cast<std::int64_t>(
                         std::floor(static_cast<double>(y) - inwards * off * along_x + 0.5))};
      };
      add_free_pieces(place(low), place(high), front.cell);
    }
  }

  /// What of a straight line is allowed, in pieces as long as can be, to 5 cm.
  void add_free_pieces(const Point& a, const Point& b, int cell) {
    const auto steps = static_cast<std::int64_t>(distance(a, b) / kFreePitch) + 1;
    const auto step = [&](std::int64_t i) {
      return Point{a.x + (b.x - a.x) * i / steps, a.y + (b.y - a.y) * i / steps};
    };
    for (std::int64_t i = 0; i <= steps;) {
      std::int64_t end = i;
      while (end < steps && query_.space->allows(step(i)) && query_.space->allows(step(end + 1)) &&
             query_.space->sees(step(i), step(end + 1))) {
        ++end;
      }
      if (end > i) add_line({{step(i), step(end)}, cell, true}, false);
      i = end + 1;
    }
  }

  const Point& end_point(int end) const {
    const std::vector<Point>& points = lines_[at(end / 2)].line.points;
    return end % 2 == 0 ? points.front() : points.back();
  }
  /// Into the line at this end of it.
  Heading inwards(int end) const {
    return {metres(end_point(end)), direction_deg(end_point(end), end_point(end ^ 1))};
  }
  Heading outwards(int end) const {
    return {metres(end_point(end)), direction_deg(end_point(end ^ 1), end_point(end))};
  }

  /// Out of a line at an end and into another at one of its ends: backwards the same way.
  std::optional<DubinsWay> way_between(int a, int b) const {
    return floor_.best_way(outwards(std::min(a, b)), inwards(std::max(a, b)));
  }
  double between(int a, int b) {
    if (a > b) std::swap(a, b);
    const auto key = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b);
    const auto [found, is_new] = costs_.try_emplace(key, kNoTurn);
    if (is_new) {
      const auto way = way_between(a, b);
      if (way) found->second = way->length() * static_cast<double>(kUnitsPerMetre);
    }
    return found->second;
  }

  /// The shortest way to an end from where the machine begins, in whatever heading.
  std::optional<DubinsWay> way_from_start(int end) const {
    std::optional<DubinsWay> best;
    const Point& p = end_point(end);
    if (p == *query_.from) {
      DubinsWay none;
      none.from = inwards(end);
      none.radius = query_.radius;
      return none;
    }
    for (int heading = 0; heading < 360; heading += kStartPitch_deg) {
      auto way =
          floor_.best_way({metres(*query_.from), static_cast<double>(heading)}, inwards(end));
      if (way && (!best || way->length() < best->length())) best = way;
    }
    return best;
  }
  double start_cost(int end) {
    if (query_.from) {
      const auto [found, is_new] = start_costs_.try_emplace(end, kNoTurn);
      if (is_new) {
        const auto way = way_from_start(end);
        if (way) found->second = way->length() * static_cast<double>(kUnitsPerMetre);
      }
      return found->second;
    }
    return first_ ? distance(*first_, end_point(end)) : 0;
  }

  int entry(const DirectedLine& line) const { return 2 * line.line + (line.reversed ? 1 : 0); }
  double cost_of(const std::vector<DirectedLine>& order) {
    double cost = start_cost(entry(order.front()));
    for (std::size_t i = 1; i < order.size(); ++i) {
      cost += between(entry(order[i - 1]) ^ 1, entry(order[i]));
    }
    return cost;
  }

  /// Lines in this order, each in the direction that makes the whole shortest.
  std::vector<DirectedLine> directed(const std::vector<int>& order) {
    std::vector<std::array<double, 2>> cost(order.size());
    std::vector<std::array<bool, 2>> before(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (const int side : {0, 1}) {
        const int end = 2 * order[i] + side;
        if (i == 0) {
          cost[i][at(side)] = start_cost(end);
          continue;
        }
        const double straight = cost[i - 1][0] + between(2 * order[i - 1] + 1, end);
        const double reversed = cost[i - 1][1] + between(2 * order[i - 1], end);
        before[i][at(side)] = reversed < straight;
        cost[i][at(side)] = std::min(straight, reversed);
      }
    }
    std::vector<DirectedLine> result(order.size());
    bool reversed = cost.back()[1] < cost.back()[0];
    for (std::size_t i = order.size(); i-- > 0;) {
      result[i] = {order[i], reversed};
      reversed = before[i][reversed ? 1 : 0];
    }
    return result;
  }

  /// Lines of each cell with `skip` between one and the next, there and back; passes at last.
  std::vector<int> skipping(std::size_t skip) const {
    std::vector<int> order, passes;
    for (std::size_t i = 0; i < lines_.size();) {
      std::size_t end = i;
      while (end < lines_.size() && lines_[end].line.cell == lines_[i].line.cell &&
             !lines_[end].line.is_pass) {
        ++end;
      }
      if (end == i) {
        passes.push_back(static_cast<int>(i++));
        continue;
      }
      for (std::size_t block = i; block < end; block += 2 * skip) {
        for (std::size_t k = 0; k < skip; ++k) {
          for (const std::size_t line : {block + k, block + k + skip}) {
            if (line < end && line < block + 2 * skip) order.push_back(static_cast<int>(line));
          }
        }
      }
      i = end;
    }
    order.insert(order.end(), passes.begin(), passes.end());
    return order;
  }

  void order_lines_by_turns() {
    if (!query_.from && query_.inlet) {
      first_ = end_point(0);
      for (int end = 1; end < static_cast<int>(2 * lines_.size()); ++end) {
        if (distance(end_point(end), *query_.inlet) > distance(*first_, *query_.inlet)) {
          first_ = end_point(end);
        }
      }
    }
    const double width = in_metres(query_.width);
    const auto widest = static_cast<std::size_t>(std::ceil(2 * query_.radius / width)) + 2;
    double least = 0;
    for (std::size_t skip = 1; skip <= std::min(widest, lines_.size()); ++skip) {
      std::vector<DirectedLine> order = directed(skipping(skip));
      const double cost = cost_of(order);
      if (!order_.empty() && cost >= least) continue;
      least = cost;
      order_ = std::move(order);
    }
    TourQuery tour;
    for (int end = 0; end < static_cast<int>(2 * lines_.size()); ++end) {
      tour.ends.push_back(end_point(end));
    }
    tour.between = [&](int a, int b) { return between(a, b); };
    if (query_.from || first_) tour.from_start = [&](int end) { return start_cost(end); };
    tour.kicks = lines_.size() <= kMostLinesForTries ? query_.tries : 0;
    improve_tour(tour, order_);
    keep_longest_part();
  }

  /// Where no turn leads from a line to the next the order falls into parts: the one that works
  /// most is driven.
  void keep_longest_part() {
    std::size_t best_from = 0, best_to = 0;
    double most = -1;
    for (std::size_t from = 0; from < order_.size();) {
      std::size_t to = from + 1;
      while (to < order_.size() &&
             between(entry(order_[to - 1]) ^ 1, entry(order_[to])) < kNoTurn) {
        ++to;
      }
      double works = 0;
      for (std::size_t i = from; i < to; ++i) {
        works += distance(end_point(2 * order_[i].line), end_point(2 * order_[i].line + 1));
      }
      const bool begins = !query_.from || start_cost(entry(order_[from])) < kNoTurn;
      if (begins && works > most) {
        most = works;
        best_from = from;
        best_to = to;
      }
      from = to;
    }
    std::vector<int> left;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (i < best_from || i >= best_to) left.push_back(order_[i].line);
    }
    order_ = {order_.begin() + static_cast<std::ptrdiff_t>(best_from),
              order_.begin() + static_cast<std::ptrdiff_t>(best_to)};
    if (lines_.size() <= kMostLinesForTries) insert(left);
    result_.cut_off += static_cast<int>(left.size());
  }

  /// Puts lines between others, or at an end, where turns lead to them and on, for the least way;
  /// what stays in `left` has no such place.
  void insert(std::vector<int>& left) {
    bool found = true;
    while (found) {
      found = false;
      for (std::size_t i = 0; i < left.size(); ++i) {
        double least = kNoTurn;
        std::size_t place = 0;
        DirectedLine best;
        for (std::size_t p = 0; p <= order_.size(); ++p) {
          for (const bool reversed : {false, true}) {
            const double cost = cost_of_inserting({left[i], reversed}, p);
            if (cost >= least) continue;
            least = cost;
            place = p;
            best = {left[i], reversed};
          }
        }
        if (least >= kNoTurn) continue;
        order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(place), best);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        found = true;
        break;
      }
    }
  }
  double cost_of_inserting(const DirectedLine& line, std::size_t place) {
    const int in = entry(line);
    const double to = place > 0 ? between(entry(order_[place - 1]) ^ 1, in) : start_cost(in);
    if (to >= kNoTurn) return kNoTurn;
    if (place == order_.size()) return to;
    const double on = between(in ^ 1, entry(order_[place]));
    if (on >= kNoTurn) return kNoTurn;
    const double before = place > 0 ? between(entry(order_[place - 1]) ^ 1, entry(order_[place]))
                                    : start_cost(entry(order_[place]));
    return to + on - before;
  }

  void drive() {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const int in = entry(order_[i]);
      if (i > 0) {
        const int out = entry(order_[i - 1]) ^ 1;
        travel(*way_between(out, in), out > in);
      } else if (query_.from) {
        travel(*way_from_start(in), false);
      }
      const Heading begin = inwards(in);
      if (result_.points.empty()) result_.points.push_back({begin, false});
      result_.points.push_back({outwards(in ^ 1), true});
      result_.length += in_metres(1) * distance(end_point(in), end_point(in ^ 1));
      WorkLine driven = lines_[at(order_[i].line)].line;
      if (order_[i].reversed) std::reverse(driven.points.begin(), driven.points.end());
      result_.lines.push_back(std::move(driven));
    }
  }

  void travel(const DubinsWay& way, bool backwards) {
    std::vector<Heading> corners = way.corners(kTurnStep_deg);
    if (backwards) {
      std::reverse(corners.begin(), corners.end());
      for (Heading& each : corners) each.heading_deg = math::normalised_deg(each.heading_deg + 180);
    }
    if (result_.points.empty()) result_.points.push_back({corners.front(), false});
    for (std::size_t i = 1; i < corners.size(); ++i) result_.points.push_back({corners[i], false});
    result_.length += way.length();
    result_.turns += way.turns();
  }

  const TurningQuery& query_;
  const TurningFloor floor_;
  std::vector<CutLine> lines_;
  std::optional<Point> first_;  ///< where a way that begins far from the inlet begins
  std::unordered_map<std::uint64_t, double> costs_;
  std::unordered_map<int, double> start_costs_;
  std::vector<DirectedLine> order_;
  TurningResult result_;
};

}  // namespace

TurningResult plan_turning(const TurningQuery& query) { return TurningPlanner(query).run(); }

}  // namespace rubicon::coverage
