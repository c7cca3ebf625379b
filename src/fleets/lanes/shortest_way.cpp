#include "src/fleets/lanes/shortest_way.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>

namespace rubicon::lanes {
namespace {

// Of what floating point makes of a sum of lanes: a promise is smaller by it than what was
// computed, so that rounding cannot make it a lie.
constexpr double kRoundingShare = 1e-12;

void check(const LaneNetwork& network, NodeIndex from, const WayOptions& options) {
  if (from < 0 || from >= network.node_count()) {
    throw std::invalid_argument(fmt::format("way: there is no node number {}", from));
  }
  if (!(options.vehicle_speed > 0)) {
    throw std::invalid_argument(
        fmt::format("way: expected a vehicle speed above 0, found {}", options.vehicle_speed));
  }
  if (!(options.vehicle_width >= 0)) {
    throw std::invalid_argument(
        fmt::format("way: expected a vehicle width of 0 or more, found {}", options.vehicle_width));
  }
  LaneIndex before = kNone;
  for (const LaneIndex lane : options.closed) {
    if (lane <= before || lane >= network.lane_count()) {
      throw std::invalid_argument("way: closed lanes have to be lanes, ascending, each once");
    }
    before = lane;
  }
}

bool is_open(const LaneNetwork& network, LaneIndex lane, const WayOptions& options) {
  return network.class_of(lane).width >= options.vehicle_width &&
         !std::binary_search(options.closed.begin(), options.closed.end(), lane);
}

std::int64_t weight_of(const LaneNetwork& network, LaneIndex lane, const WayOptions& options) {
  switch (options.criterion) {
    case Criterion::kTime:
      return network.time(lane, options.vehicle_speed);
    case Criterion::kDistance:
      return nanoseconds_of(network.length(lane));
    case Criterion::kCost:
      return nanoseconds_of(network.length(lane) * network.class_of(lane).cost);
  }
  return kNoWay;
}

// The weight that a straight metre takes at least.
double least_per_metre(const LaneNetwork& network, const WayOptions& options) {
  const LaneNetwork::Bounds& best = network.bounds();
  if (network.lane_count() == 0 || !std::isfinite(best.stretch)) return 0;
  double metre = 1e9;  // of a length
  if (options.criterion == Criterion::kTime) metre /= std::min(best.speed, options.vehicle_speed);
  if (options.criterion == Criterion::kCost) metre *= best.cost;
  // Each lane is rounded to a whole number, by half of one at most.
  const double rounding = 0.5 / (best.length * metre);
  const double share = 1 - rounding - kRoundingShare;
  return share > 0 ? metre * best.stretch * share : 0;
}

struct Open {
  std::int64_t estimate;  // of the whole way
  std::int64_t weight;    // so far
  NodeIndex node;
  bool operator>(const Open& other) const {
    if (estimate != other.estimate) return estimate > other.estimate;
    if (weight != other.weight) return weight < other.weight;  // nearer to the goal first
    return node > other.node;
  }
};

// To one goal by A*, or to all nodes (goal kNone).
WaysFrom search(const LaneNetwork& network, NodeIndex from, NodeIndex goal,
                const WayOptions& options, SearchCounts& counts) {
  const auto nodes = static_cast<std::size_t>(network.node_count());
  WaysFrom ways{from, std::vector<std::int64_t>(nodes, kNoWay),
                std::vector<LaneIndex>(nodes, kNone)};
  const double per_metre = goal == kNone ? 0 : least_per_metre(network, options);
  const auto to_go = [&](NodeIndex node) -> std::int64_t {
    if (per_metre == 0) return 0;
    return static_cast<std::int64_t>(
        std::min(network.distance(node, goal) * per_metre, static_cast<double>(kNoWay)));
  };
  const auto weight = [&ways](NodeIndex node) -> std::int64_t& {
    return ways.weight[static_cast<std::size_t>(node)];
  };

  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  weight(from) = 0;
  open.push({to_go(from), 0, from});
  while (!open.empty()) {
    const Open now = open.top();
    open.pop();
    // Also what may be equally good is gone through: then ties do not hang on the order here.
    if (goal != kNone && now.estimate > weight(goal)) break;
    if (now.weight != weight(now.node)) continue;
    ++counts.expanded;
    for (const LaneIndex lane : network.leaving(now.node)) {
      if (!is_open(network, lane, options)) continue;
      const std::int64_t step = weight_of(network, lane, options);
      if (step >= kNoWay - now.weight) continue;
      const std::int64_t there = now.weight + step;
      const NodeIndex next = network.lane(lane).to;
      LaneIndex& last = ways.last[static_cast<std::size_t>(next)];
      if (there < weight(next)) {
        weight(next) = there;
        last = lane;
        const std::int64_t rest = to_go(next);
        if (rest < kNoWay - there) open.push({there + rest, there, next});
      } else if (there == weight(next)) {
        last = std::min(last, lane);
      }
    }
  }
  return ways;
}

}  // namespace

std::string_view name_of(Criterion criterion) {
  switch (criterion) {
    case Criterion::kTime:
      return "time";
    case Criterion::kDistance:
      return "distance";
    case Criterion::kCost:
      return "cost";
  }
  return "";
}

std::optional<Way> shortest_way(const LaneNetwork& network, NodeIndex from, NodeIndex to,
                                const WayOptions& options) {
  SearchCounts counts;
  return shortest_way(network, from, to, options, counts);
}

std::optional<Way> shortest_way(const LaneNetwork& network, NodeIndex from, NodeIndex to,
                                const WayOptions& options, SearchCounts& counts) {
  check(network, from, options);
  check(network, to, options);
  return way_to(network, search(network, from, to, options, counts), to, options);
}

WaysFrom ways_from(const LaneNetwork& network, NodeIndex from, const WayOptions& options) {
  check(network, from, options);
  SearchCounts counts;
  return search(network, from, kNone, options, counts);
}

std::optional<Way> way_to(const LaneNetwork& network, const WaysFrom& ways, NodeIndex to,
                          const WayOptions& options) {
  if (to < 0 || to >= network.node_count()) {
    throw std::invalid_argument(fmt::format("way: there is no node number {}", to));
  }
  if (ways.weight[static_cast<std::size_t>(to)] >= kNoWay) return std::nullopt;
  Way way;
  way.nodes.push_back(to);
  for (NodeIndex node = to; node != ways.from;) {
    const LaneIndex lane = ways.last[static_cast<std::size_t>(node)];
    way.lanes.push_back(lane);
    node = network.lane(lane).from;
    way.nodes.push_back(node);
  }
  std::reverse(way.nodes.begin(), way.nodes.end());
  std::reverse(way.lanes.begin(), way.lanes.end());
  for (const LaneIndex lane : way.lanes) {
    way.time += std::min(network.time(lane, options.vehicle_speed), kEndOfTime - way.time);
    way.length += network.length(lane);
    way.cost += network.length(lane) * network.class_of(lane).cost;
  }
  return way;
}

}  // namespace rubicon::lanes
