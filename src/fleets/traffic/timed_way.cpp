#include "src/fleets/traffic/timed_way.hpp"

#include <algorithm>
#include <queue>
#include <tuple>

namespace rubicon::traffic {

namespace {

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

/// When the node is nobody's, ascending. Interval i ends where hold i begins.
Nanoseconds safe_from(const std::vector<Hold>& holds, std::size_t interval) {
  return interval == 0 ? 0 : holds[interval - 1].until;
}
Nanoseconds safe_until(const std::vector<Hold>& holds, std::size_t interval) {
  return interval == holds.size() ? lanes::kEndOfTime : holds[interval].from;
}

/// The first moment from `enter` on at which nobody is too near to the lane for so long.
Nanoseconds enter_between(const std::vector<Hold>& holds, Nanoseconds enter, Nanoseconds takes) {
  for (const Hold& hold : holds) {
    if (hold.until <= enter) continue;
    if (hold.from >= enter + takes) break;
    enter = hold.until;
  }
  return enter;
}

}  // namespace

TimedWays::TimedWays(const TimedWayQuery& query) {
  const LaneNetwork& network = *query.network;
  const auto nodes = at(network.node_count());
  last_.assign(nodes, -1);
  std::vector<std::size_t> first_interval(nodes + 1, 0);
  for (std::size_t node = 0; node < nodes; ++node) {
    first_interval[node + 1] = first_interval[node] + query.holds[node].size() + 1;
  }
  std::vector<bool> settled(first_interval[nodes], false);
  struct Open {
    Label label;
    std::size_t state = 0;
    Nanoseconds rank = 0;  ///< arrival, at the goal at least if there is one
    std::int64_t number = 0;
    bool operator<(const Open& other) const {
      return std::tie(rank, number) > std::tie(other.rank, other.number);
    }
  };
  std::priority_queue<Open> open;
  std::int64_t number = 0;
  const bool is_led = !query.least.empty();
  const auto rank_of = [&](NodeIndex node, Nanoseconds arrive) {
    return is_led ? arrive + query.least[at(node)] : arrive;
  };
  const auto& own = query.holds[at(query.from)];
  // The vehicle stands there, so that the interval that it stands in is its own.
  std::size_t interval = 0;
  while (interval < own.size() && own[interval].until <= query.start) ++interval;
  open.push({{query.from, safe_until(own, interval), query.start, query.start, lanes::kNone, -1},
             first_interval[at(query.from)] + interval,
             rank_of(query.from, query.start),
             number++});
  while (!open.empty()) {
    const Open best = open.top();
    open.pop();
    if (settled[best.state]) continue;
    settled[best.state] = true;
    const int index = static_cast<int>(labels_.size());
    labels_.push_back(best.label);
    const Label& label = best.label;
    if (label.end == lanes::kEndOfTime && last_[at(label.node)] < 0) {
      last_[at(label.node)] = index;
      if (label.node == query.goal) return;
    }
    for (const LaneIndex lane : network.leaving(label.node)) {
      if (network.class_of(lane).width < query.width) continue;
      const NodeIndex to = network.lane(lane).to;
      const Nanoseconds takes = network.time(lane, query.speed);
      if (takes >= lanes::kEndOfTime - label.arrive) continue;
      if (is_led && query.least[at(to)] >= lanes::kEndOfTime - label.arrive - takes) continue;
      const std::vector<Hold>& holds = query.holds[at(to)];
      for (std::size_t i = 0; i <= holds.size(); ++i) {
        Nanoseconds enter = std::max(label.arrive, safe_from(holds, i));
        if (!query.lane_holds.empty()) {
          enter = enter_between(query.lane_holds[at(lane)], enter, takes);
          if (enter >= lanes::kEndOfTime - takes) break;
        }
        const Nanoseconds arrive = enter + takes;
        if (arrive > label.end) break;  // the node behind it is needed by then
        const Nanoseconds end = safe_until(holds, i);
        const std::size_t state = first_interval[at(to)] + i;
        if (arrive > end || settled[state]) continue;
        open.push({{to, end, enter, arrive, lane, index}, state, rank_of(to, arrive), number++});
      }
    }
  }
}

int TimedWays::last_of(NodeIndex node) const { return last_[at(node)]; }

std::optional<std::vector<TimedNode>> TimedWays::to(NodeIndex goal) const {
  int label = last_of(goal);
  if (label < 0) return std::nullopt;
  std::vector<TimedNode> way;
  for (; label >= 0; label = labels_[at(label)].before) {
    const Label& each = labels_[at(label)];
    way.push_back({each.node, each.lane, each.enter, each.arrive});
  }
  std::reverse(way.begin(), way.end());
  return way;
}

std::vector<NodeIndex> TimedWays::resting_places() const {
  std::vector<NodeIndex> places;
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    const Label& label = labels_[i];
    if (last_of(label.node) == static_cast<int>(i)) places.push_back(label.node);
  }
  return places;
}

}  // namespace rubicon::traffic
