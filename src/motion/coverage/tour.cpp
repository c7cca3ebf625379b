#include "src/motion/coverage/tour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

constexpr std::size_t kNeighbours = 10;
constexpr int kLongestBlock = 3;
/// Smaller gains are noise of rounding: a tenth of a unit.
constexpr double kLeastGain = 0.1;

class Tour {
 public:
  Tour(const TourQuery& query, std::vector<DirectedLine>& order)
      : query_(query), order_(order), place_(query.ends.size() / 2, -1) {
    renumber(0, size());
    find_neighbours();
  }

  void run() {
    std::vector<int> dirty;
    for (const DirectedLine& item : order_) dirty.push_back(item.line);
    settle(std::move(dirty));
    if (size() < 8) return;
    std::mt19937 engine(1993);  // NOLINT(cert-msc51-cpp): the same tour every time
    for (int kick = 0; kick < query_.kicks; ++kick) {
      const std::vector<DirectedLine> kept = order_;
      // Two neighbouring blocks change places.
      const int first = static_cast<int>(engine() % static_cast<std::uint32_t>(size() - 3));
      const int length_a = 1 + static_cast<int>(engine() % 8U);
      const int length_b = 1 + static_cast<int>(engine() % 8U);
      const int middle = std::min(first + length_a, size() - 1);
      const int last = std::min(middle + length_b, size());
      if (!same_group(first, last - 1)) continue;
      const double before = gap(first) + gap(middle) + gap(last);
      std::rotate(order_.begin() + first, order_.begin() + middle, order_.begin() + last);
      renumber(first, last);
      const int joint = first + last - middle;
      gained_ = before - gap(first) - gap(joint) - gap(last);
      std::vector<int> dirty_now;
      for (const int p : {first - 1, first, joint - 1, joint, last - 1, last}) {
        if (p >= 0 && p < size()) dirty_now.push_back(order_[at(p)].line);
      }
      settle(std::move(dirty_now));
      if (gained_ >= 0) continue;
      order_ = kept;
      renumber(0, size());
    }
  }

 private:
  int size() const { return static_cast<int>(order_.size()); }
  int front(int p) const { return 2 * order_[at(p)].line + (order_[at(p)].reversed ? 1 : 0); }
  int back(int p) const { return front(p) ^ 1; }
  /// From the thing before place p to that at p, both given as ends; -1 stands for none.
  double cost(int end, int next) const {
    if (next < 0) return 0;
    if (end < 0) return query_.from_start ? query_.from_start(next) : 0;
    return query_.between(end, next);
  }
  /// The cost where it is `limit` or less, else anything more.
  double cost_within(int end, int next, double limit) const {
    if (end < 0 || next < 0 || !query_.between_within) return cost(end, next);
    return query_.between_within(end, next, limit);
  }
  /// Whether new joins cost so much less than `saved` that it helps. Asks for the nearest first,
  /// and for no way that is longer than what could still help.
  template <std::size_t count>
  bool helps(const int (&joins)[count][2], double saved) const {
    std::array<std::pair<double, std::size_t>, count> least;
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      least[i] = {least_cost(joins[i][0], joins[i][1]), i};
      sum += least[i].first;
    }
    if (saved - sum <= kLeastGain) return false;
    std::sort(least.begin(), least.end());
    for (const auto& [straight, i] : least) {
      const double limit = saved - (sum - straight);
      const double found = cost_within(joins[i][0], joins[i][1], limit);
      if (found > limit) return false;
      sum += found - straight;
    }
    return true;
  }
  /// No more than the cost, and quick to find.
  double least_cost(int end, int next) const {
    if (next < 0 || end < 0) return 0;
    return distance(query_.ends[at(end)], query_.ends[at(next)]);
  }
  int back_or_none(int p) const { return p < 0 ? -1 : back(p); }
  int front_or_none(int p) const { return p >= size() ? -1 : front(p); }
  double gap(int p) const { return cost(back_or_none(p - 1), front_or_none(p)); }
  bool same_group(int p, int q) const {
    return query_.groups.empty() ||
           query_.groups[at(order_[at(p)].line)] == query_.groups[at(order_[at(q)].line)];
  }
  void renumber(int low, int high) {
    for (int p = low; p < high; ++p) place_[at(order_[at(p)].line)] = p;
  }

  void find_neighbours() {
    std::vector<int> ends;
    for (const DirectedLine& item : order_) {
      ends.push_back(2 * item.line);
      ends.push_back(2 * item.line + 1);
    }
    Box box{query_.ends[at(ends[0])], query_.ends[at(ends[0])]};
    for (const int end : ends) {
      const Point& p = query_.ends[at(end)];
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    Buckets buckets(box, ends.size());
    for (const int end : ends) {
      buckets.add(end, query_.ends[at(end)], query_.ends[at(end)]);
    }
    neighbours_.resize(query_.ends.size());
    const std::int64_t whole = std::max<std::int64_t>(box.width() + box.height(), 1);
    const auto share = static_cast<std::int64_t>(std::sqrt(static_cast<double>(ends.size()))) + 1;
    for (const int end : ends) {
      const Point& p = query_.ends[at(end)];
      std::vector<std::pair<double, int>> found;
      for (std::int64_t reach = whole / share + 1;; reach *= 2) {
        found.clear();
        std::size_t within = 0;
        buckets.any_in({{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}}, [&](int other) {
          if (other / 2 == end / 2) return false;
          found.emplace_back(distance(p, query_.ends[at(other)]), other);
          within += found.back().first <= static_cast<double>(reach);
          return false;
        });
        if (within >= kNeighbours || reach > whole) break;
      }
      const std::size_t count = std::min(found.size(), kNeighbours);
      std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count),
                        found.end());
      for (std::size_t k = 0; k < count; ++k) neighbours_[at(end)].push_back(found[k].second);
    }
  }

  void settle(std::vector<int> dirty) {
    std::vector<bool> waits(query_.ends.size() / 2, false);
    for (const int item : dirty) waits[at(item)] = true;
    std::reverse(dirty.begin(), dirty.end());
    while (!dirty.empty()) {
      const int item = dirty.back();
      dirty.pop_back();
      waits[at(item)] = false;
      touched_.clear();
      while (improve(item)) {
      }
      for (const int p : touched_) {
        const int other = order_[at(p)].line;
        if (waits[at(other)]) continue;
        waits[at(other)] = true;
        dirty.push_back(other);
      }
    }
  }

  bool improve(int item) {
    const int p = place_[at(item)];
    const double after = gap(p + 1);
    const double before = gap(p);
    // A free end costs nothing and may still be worth joining to another: the whole tour shrinks.
    for (const int end : neighbours_[at(back(p))]) {
      const double straight = distance(query_.ends[at(back(p))], query_.ends[at(end)]);
      if (p + 1 < size() && straight >= after) break;
      const int q = place_[at(end / 2)];
      if (end == back(q)) {
        if (q > p ? reverse(p + 1, q) : reverse(q + 1, p)) return true;
        for (int k = 0; k < kLongestBlock; ++k) {
          if (move(q - k, q, p + 1, true)) return true;
        }
      } else {
        for (int k = 0; k < kLongestBlock; ++k) {
          if (move(q, q + k, p + 1, false)) return true;
          if (move(p - k, p, q, false)) return true;
        }
      }
    }
    for (const int end : neighbours_[at(front(p))]) {
      const double straight = distance(query_.ends[at(front(p))], query_.ends[at(end)]);
      if (p > 0 && straight >= before) break;
      const int q = place_[at(end / 2)];
      if (end == front(q)) {
        if (q > p ? reverse(p, q - 1) : reverse(q, p - 1)) return true;
        for (int k = 0; k < kLongestBlock; ++k) {
          if (move(q, q + k, p, true)) return true;
        }
      } else {
        for (int k = 0; k < kLongestBlock; ++k) {
          if (move(q - k, q, p, false)) return true;
          if (move(p, p + k, q + 1, false)) return true;
        }
      }
    }
    return false;
  }

  /// Turns the block of places low to high round, where that helps.
  bool reverse(int low, int high) {
    if (low < 0 || high >= size() || low > high || !same_group(low, high)) return false;
    const double saved = gap(low) + gap(high + 1);
    const int before = back_or_none(low - 1);
    const int after = front_or_none(high + 1);
    const int joins[2][2] = {{before, back(high)}, {front(low), after}};
    if (!helps(joins, saved)) return false;
    const double gain = saved - cost(before, back(high)) - cost(front(low), after);
    if (gain <= kLeastGain) return false;
    turn(low, high);
    done(gain, {low - 1, low, high, high + 1});
    return true;
  }

  void turn(int low, int high) {
    std::reverse(order_.begin() + low, order_.begin() + high + 1);
    for (int p = low; p <= high; ++p) order_[at(p)].reversed = !order_[at(p)].reversed;
    renumber(low, high + 1);
  }

  /// Moves the block of places low to high in front of place `to`, where that helps.
  bool move(int low, int high, int to, bool turned) {
    if (low < 0 || high >= size() || (to >= low && to <= high + 1) || to < 0 || to > size()) {
      return false;
    }
    if (!same_group(std::min(low, to), std::max(high, to - 1))) return false;
    const int first = turned ? back(high) : front(low);
    const int last = turned ? front(low) : back(high);
    const double saved = gap(low) + gap(high + 1) + gap(to);
    const int joins[3][2] = {{back_or_none(low - 1), front_or_none(high + 1)},
                             {back_or_none(to - 1), first},
                             {last, front_or_none(to)}};
    if (!helps(joins, saved)) return false;
    double gain = saved;
    for (const auto& [end, next] : joins) gain -= cost(end, next);
    if (gain <= kLeastGain) return false;
    if (turned) turn(low, high);
    const int from = std::min(low, to);
    const int until = std::max(high + 1, to);
    const int middle = to < low ? low : high + 1;
    std::rotate(order_.begin() + from, order_.begin() + middle, order_.begin() + until);
    renumber(from, until);
    const int joint = from + until - middle;
    done(gain, {from - 1, from, joint - 1, joint, until - 1, until});
    return true;
  }

  void done(double gain, std::initializer_list<int> places) {
    gained_ += gain;
    for (const int p : places) {
      if (p >= 0 && p < size()) touched_.push_back(p);
    }
  }

  const TourQuery& query_;
  std::vector<DirectedLine>& order_;
  std::vector<int> place_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<int> touched_;
  double gained_ = 0;
};

}  // namespace

void improve_tour(const TourQuery& query, std::vector<DirectedLine>& order) {
  if (order.size() > 1) Tour(query, order).run();
}

}  // namespace rubicon::coverage
