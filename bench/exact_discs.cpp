#include "bench/exact_discs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <queue>
#include <tuple>
#include <utility>

namespace rubicon::bench {

namespace {

using lanes::LaneIndex;
using lanes::LaneNetwork;
using lanes::NodeIndex;
using traffic::Trip;

constexpr double kNever = std::numeric_limits<double>::infinity();
/// m: discs that come nearer to each other by less only touch.
constexpr double kTouch = 1e-6;
/// s
constexpr double kSameTime = 1e-9;

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

/// A move along a lane, or a stay at a node until `end`.
struct Action {
  LaneIndex lane = lanes::kNone;
  NodeIndex node = lanes::kNone;  ///< of a stay
  double begin = 0;
  double end = 0;
};
using Plan = std::vector<Action>;

/// Open intervals of time, ascending, without overlaps.
class Forbidden {
 public:
  void add(double from, double until) {
    all_.emplace_back(from, until);
    std::sort(all_.begin(), all_.end());
    std::vector<std::pair<double, double>> merged;
    for (const auto& each : all_) {
      if (!merged.empty() && each.first < merged.back().second) {
        merged.back().second = std::max(merged.back().second, each.second);
      } else {
        merged.push_back(each);
      }
    }
    all_ = std::move(merged);
  }
  /// The first time from `t` on that is not forbidden.
  double next(double t) const {
    for (const auto& [from, until] : all_) {
      if (t > from + kSameTime && t < until - kSameTime) t = until;
      // A move that begins where an interval begins would meet what it was made for.
      if (std::abs(t - from) <= kSameTime) t = until;
    }
    return t;
  }
  const std::vector<std::pair<double, double>>& all() const { return all_; }

 private:
  std::vector<std::pair<double, double>> all_;
};

/// What one disc may not do.
struct Limits {
  std::map<LaneIndex, Forbidden> starts;
  std::map<NodeIndex, Forbidden> stays;
};

struct Motion {
  double x = 0, y = 0;    ///< at `begin`
  double vx = 0, vy = 0;  ///< m/s
  double begin = 0, end = 0;
};

class Solver {
 public:
  Solver(const LaneNetwork& network, double diameter, const std::vector<Trip>& trips)
      : network_(network), diameter_(diameter - kTouch), trips_(trips) {
    for (const Trip& trip : trips) least_.push_back(times_to(trip));
  }

  std::optional<double> run(int most_nodes) {
    struct Node {
      std::vector<Limits> limits;
      std::vector<Plan> plans;
      double cost = 0;
    };
    struct Entry {
      double cost = 0;
      int number = 0;
      std::shared_ptr<Node> node;
      bool operator<(const Entry& other) const {
        return std::tie(cost, number) > std::tie(other.cost, other.number);
      }
    };
    std::priority_queue<Entry> open;
    auto root = std::make_shared<Node>();
    root->limits.resize(trips_.size());
    for (std::size_t i = 0; i < trips_.size(); ++i) {
      auto plan = find(i, root->limits[i]);
      if (!plan) return std::nullopt;
      root->cost += plan->back().begin;
      root->plans.push_back(std::move(*plan));
    }
    open.push({root->cost, 0, root});
    for (int number = 1; !open.empty() && number < most_nodes;) {
      const std::shared_ptr<Node> best = open.top().node;
      open.pop();
      const auto conflict = first_conflict(best->plans);
      if (!conflict) return best->cost;
      for (const bool second : {false, true}) {
        auto child = std::make_shared<Node>(*best);
        const auto who = static_cast<std::size_t>(second ? conflict->b : conflict->a);
        forbid(*conflict, second, child->limits[who]);
        auto plan = find(who, child->limits[who]);
        if (!plan) continue;
        child->cost += plan->back().begin - child->plans[who].back().begin;
        child->plans[who] = std::move(*plan);
        open.push({child->cost, number++, child});
      }
    }
    return std::nullopt;
  }

 private:
  struct Conflict {
    int a = 0, b = 0;
    Action of_a, of_b;
    double when = 0;
  };

  double takes(LaneIndex lane, const Trip& trip) const {
    return network_.length(lane) / std::min(trip.speed, network_.class_of(lane).speed);
  }

  /// By node: the time to the goal alone.
  std::vector<double> times_to(const Trip& trip) const {
    std::vector<double> times(at(network_.node_count()), kNever);
    times[at(trip.to)] = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (LaneIndex lane = 0; lane < network_.lane_count(); ++lane) {
        const double time = times[at(network_.lane(lane).to)] + takes(lane, trip);
        double& from = times[at(network_.lane(lane).from)];
        if (time < from - kSameTime) {
          from = time;
          changed = true;
        }
      }
    }
    return times;
  }

  /// The quickest plan within the limits, by safe intervals.
  std::optional<Plan> find(std::size_t who, const Limits& limits) const {
    const Trip& trip = trips_[who];
    const auto intervals_of = [&](NodeIndex node) {
      std::vector<std::pair<double, double>> safe;
      double from = 0;
      if (const auto found = limits.stays.find(node); found != limits.stays.end()) {
        for (const auto& [begin, end] : found->second.all()) {
          if (begin >= from) safe.emplace_back(from, begin);
          from = end;
        }
      }
      safe.emplace_back(from, kNever);
      return safe;
    };
    struct Label {
      NodeIndex node = lanes::kNone;
      std::size_t interval = 0;
      double time = 0;
      double until = 0;
      LaneIndex lane = lanes::kNone;
      double left = 0;  ///< when it left the node before
      int before = -1;
    };
    std::vector<Label> labels;
    using Entry = std::tuple<double, double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::map<std::pair<NodeIndex, std::size_t>, double> reached;
    const auto push = [&](const Label& label) {
      const auto [place, is_new] =
          reached.emplace(std::pair(label.node, label.interval), label.time);
      if (!is_new) {
        if (place->second <= label.time + kSameTime) return;
        place->second = label.time;
      }
      open.emplace(label.time + least_[who][at(label.node)], -label.time,
                   static_cast<int>(labels.size()));
      labels.push_back(label);
    };
    const auto first = intervals_of(trip.from).front();
    if (first.first > 0) return std::nullopt;
    push({trip.from, 0, 0, first.second, lanes::kNone, 0, -1});
    while (!open.empty()) {
      const int index = std::get<2>(open.top());
      open.pop();
      const Label here = labels[at(index)];
      if (reached.at({here.node, here.interval}) < here.time - kSameTime) continue;
      if (here.node == trip.to && here.until == kNever) {
        Plan plan = {{lanes::kNone, trip.to, here.time, kNever}};
        for (int i = index; labels[at(i)].before >= 0; i = labels[at(i)].before) {
          const Label& each = labels[at(i)];
          const Label& before = labels[at(each.before)];
          plan.push_back({each.lane, lanes::kNone, each.left, each.time});
          if (each.left > before.time) {
            plan.push_back({lanes::kNone, before.node, before.time, each.left});
          }
        }
        std::reverse(plan.begin(), plan.end());
        return plan;
      }
      for (const LaneIndex lane : network_.leaving(here.node)) {
        const NodeIndex to = network_.lane(lane).to;
        if (least_[who][at(to)] == kNever) continue;
        const double duration = takes(lane, trip);
        const auto starts = limits.starts.find(lane);
        const auto safe = intervals_of(to);
        for (std::size_t i = 0; i < safe.size(); ++i) {
          double start = std::max(here.time, safe[i].first - duration);
          if (starts != limits.starts.end()) start = starts->second.next(start);
          if (start > here.until) break;
          if (start + duration > safe[i].second) continue;
          push({to, i, start + duration, safe[i].second, lane, start, index});
        }
      }
    }
    return std::nullopt;
  }

  Motion motion_of(const Action& action, const Trip& trip) const {
    if (action.lane == lanes::kNone) {
      const lanes::Node& node = network_.node(action.node);
      return {node.x, node.y, 0, 0, action.begin, action.end};
    }
    const lanes::Node& from = network_.node(network_.lane(action.lane).from);
    const lanes::Node& to = network_.node(network_.lane(action.lane).to);
    const double duration = takes(action.lane, trip);
    return {from.x,
            from.y,
            (to.x - from.x) / duration,
            (to.y - from.y) / duration,
            action.begin,
            action.begin + duration};
  }

  /// From when to when two come too near to each other, both as they move.
  std::optional<std::pair<double, double>> meeting(const Motion& a, const Motion& b) const {
    const double from = std::max(a.begin, b.begin);
    const double until = std::min(a.end, b.end);
    if (!(from < until)) return std::nullopt;
    const double x = a.x + a.vx * (from - a.begin) - b.x - b.vx * (from - b.begin);
    const double y = a.y + a.vy * (from - a.begin) - b.y - b.vy * (from - b.begin);
    const double vx = a.vx - b.vx;
    const double vy = a.vy - b.vy;
    const double square = vx * vx + vy * vy;
    const double inside = x * x + y * y - diameter_ * diameter_;
    if (square < 1e-18) {
      if (inside >= 0) return std::nullopt;
      return std::pair(from, until);
    }
    const double half = x * vx + y * vy;
    const double root = half * half - square * inside;
    if (root <= 0) return std::nullopt;
    const double begin = std::max(from, from + (-half - std::sqrt(root)) / square);
    const double end = std::min(until, from + (-half + std::sqrt(root)) / square);
    if (begin >= end - kSameTime) return std::nullopt;
    return std::pair(begin, end);
  }

  std::optional<Conflict> first_conflict(const std::vector<Plan>& plans) const {
    std::optional<Conflict> first;
    for (std::size_t i = 0; i < plans.size(); ++i) {
      for (std::size_t k = i + 1; k < plans.size(); ++k) {
        for (const Action& a : plans[i]) {
          for (const Action& b : plans[k]) {
            if (a.begin >= b.end || b.begin >= a.end) continue;
            const auto found = meeting(motion_of(a, trips_[i]), motion_of(b, trips_[k]));
            if (!found || (first && found->first >= first->when)) continue;
            first = Conflict{static_cast<int>(i), static_cast<int>(k), a, b, found->first};
          }
        }
      }
    }
    return first;
  }

  void forbid(const Conflict& conflict, bool second, Limits& limits) const {
    const auto who = static_cast<std::size_t>(second ? conflict.b : conflict.a);
    const auto other = static_cast<std::size_t>(second ? conflict.a : conflict.b);
    const Action& own = second ? conflict.of_b : conflict.of_a;
    const Action& met = second ? conflict.of_a : conflict.of_b;
    const Motion moves = motion_of(own, trips_[who]);
    const Motion meets = motion_of(met, trips_[other]);
    const auto window = *meeting(moves, meets);
    // Of the time at which one of them waits in the way of the other, the middle third.
    const double third = (std::min(window.second, window.first + 1e6) - window.first) / 3;
    const double from = window.first + third;
    const double until = window.first + 2 * third;
    if (own.lane == lanes::kNone) {
      limits.stays[own.node].add(from, until);
    } else if (met.lane == lanes::kNone) {
      // All begins with which it is in the way of who waits there during all of that.
      Motion stays = meets;
      stays.begin = moves.begin;
      stays.end = moves.end;
      const auto near = *meeting(moves, stays);
      limits.starts[own.lane].add(own.begin + until - near.second, own.begin + from - near.first);
    } else {
      limits.starts[own.lane].add(own.begin, first_free(moves, meets));
    }
  }

  /// The first begin from that of `moves` on with which it does not meet the other.
  double first_free(Motion moves, const Motion& meets) const {
    const double begin = moves.begin;
    const double duration = moves.end - moves.begin;
    double low = 0;
    double high = meets.end - begin;
    for (int i = 0; i < 100 && high - low > kSameTime; ++i) {
      const double middle = (low + high) / 2;
      moves.begin = begin + middle;
      moves.end = moves.begin + duration;
      (meeting(moves, meets) ? low : high) = middle;
    }
    return begin + high;
  }

  const LaneNetwork& network_;
  double diameter_;
  const std::vector<Trip>& trips_;
  std::vector<std::vector<double>> least_;
};

}  // namespace

std::optional<double> exact_discs(const LaneNetwork& network, double diameter,
                                  const std::vector<Trip>& trips, int most_nodes) {
  return Solver(network, diameter, trips).run(most_nodes);
}

}  // namespace rubicon::bench
