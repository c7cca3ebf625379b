#include "src/fleets/traffic/nearness.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace rubicon::traffic {

namespace {

/// m: discs that come this much nearer to each other touch.
constexpr double kDiscTouching = 1e-9;

struct Spot {
  double x = 0;
  double y = 0;
};

struct Stretch {
  Spot a, b;
};

double to_stretch(const Spot& place, const Stretch& line) {
  const double dx = line.b.x - line.a.x;
  const double dy = line.b.y - line.a.y;
  const double length = dx * dx + dy * dy;
  double t = length > 0 ? ((place.x - line.a.x) * dx + (place.y - line.a.y) * dy) / length : 0;
  t = std::clamp(t, 0.0, 1.0);
  const double x = line.a.x + t * dx - place.x;
  const double y = line.a.y + t * dy - place.y;
  return std::sqrt(x * x + y * y);
}

double side_of(const Stretch& line, const Spot& place) {
  return (line.b.x - line.a.x) * (place.y - line.a.y) -
         (line.b.y - line.a.y) * (place.x - line.a.x);
}

double between(const Stretch& a, const Stretch& b) {
  const bool parts_b = (side_of(a, b.a) > 0) != (side_of(a, b.b) > 0);
  const bool parts_a = (side_of(b, a.a) > 0) != (side_of(b, a.b) > 0);
  if (parts_a && parts_b) return 0;
  return std::min({to_stretch(a.a, b), to_stretch(a.b, b), to_stretch(b.a, a), to_stretch(b.b, a)});
}

}  // namespace

Nearness nearness_of(const LaneNetwork& network, double diameter) {
  const double least = diameter - kDiscTouching;
  const auto nodes = static_cast<std::size_t>(network.node_count());
  const auto count = static_cast<std::size_t>(network.lane_count());
  Nearness near;
  near.lanes_by_lane.resize(count);
  near.nodes_by_lane.resize(count);
  near.lanes_by_node.resize(nodes);
  near.nodes_by_node.resize(nodes);
  std::vector<Spot> spots;
  for (NodeIndex node = 0; node < network.node_count(); ++node) {
    spots.push_back({network.node(node).x, network.node(node).y});
    for (NodeIndex other = 0; other < node; ++other) {
      if (network.distance(node, other) >= least) continue;
      near.nodes_by_node[static_cast<std::size_t>(node)].push_back(other);
      near.nodes_by_node[static_cast<std::size_t>(other)].push_back(node);
    }
  }
  std::vector<Stretch> lines;
  for (LaneIndex lane = 0; lane < network.lane_count(); ++lane) {
    const lanes::Lane& each = network.lane(lane);
    lines.push_back(
        {spots[static_cast<std::size_t>(each.from)], spots[static_cast<std::size_t>(each.to)]});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const lanes::Lane& lane = network.lane(static_cast<LaneIndex>(i));
    for (std::size_t node = 0; node < nodes; ++node) {
      const auto index = static_cast<NodeIndex>(node);
      if (index == lane.from || index == lane.to) continue;
      if (to_stretch(spots[node], lines[i]) >= least) continue;
      near.nodes_by_lane[i].push_back(index);
      near.lanes_by_node[node].push_back(static_cast<LaneIndex>(i));
    }
  }
  // From west to east: a lane that begins east of the end of another is not near to it.
  const auto west = [&](std::size_t i) { return std::min(lines[i].a.x, lines[i].b.x); };
  const auto east = [&](std::size_t i) { return std::max(lines[i].a.x, lines[i].b.x); };
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return west(a) < west(b); });
  for (std::size_t place = 0; place < count; ++place) {
    const std::size_t i = order[place];
    const lanes::Lane& lane = network.lane(static_cast<LaneIndex>(i));
    for (std::size_t next = place + 1; next < count; ++next) {
      const std::size_t k = order[next];
      if (west(k) >= east(i) + least) break;
      const lanes::Lane& other = network.lane(static_cast<LaneIndex>(k));
      if (lane.from == other.from || lane.from == other.to || lane.to == other.from ||
          lane.to == other.to) {
        continue;
      }
      if (std::min(lines[i].a.y, lines[i].b.y) >= std::max(lines[k].a.y, lines[k].b.y) + least ||
          std::min(lines[k].a.y, lines[k].b.y) >= std::max(lines[i].a.y, lines[i].b.y) + least ||
          between(lines[i], lines[k]) >= least) {
        continue;
      }
      near.lanes_by_lane[i].push_back(static_cast<LaneIndex>(k));
      near.lanes_by_lane[k].push_back(static_cast<LaneIndex>(i));
    }
  }
  for (std::vector<LaneIndex>& each : near.lanes_by_lane) std::sort(each.begin(), each.end());
  return near;
}

LaneNetwork divided(const LaneNetwork& network, double piece) {
  if (!(piece > 0)) throw std::invalid_argument("a piece of a lane has no length");
  lanes::NetworkDescription description;
  description.classes = network.classes();
  for (NodeIndex node = 0; node < network.node_count(); ++node) {
    description.nodes.push_back(network.node(node));
  }
  // By the ends of a lane, the lower number first: the nodes between them, from there.
  std::map<std::pair<NodeIndex, NodeIndex>, std::vector<NodeIndex>> between_ends;
  for (LaneIndex i = 0; i < network.lane_count(); ++i) {
    const lanes::Lane& lane = network.lane(i);
    const auto ends = std::minmax(lane.from, lane.to);
    const auto [found, is_new] = between_ends.try_emplace({ends.first, ends.second});
    const lanes::Node& from = network.node(ends.first);
    const lanes::Node& to = network.node(ends.second);
    const int parts = std::max(1, static_cast<int>(network.length(i) / piece));
    for (int k = 1; k < parts && is_new; ++k) {
      found->second.push_back(static_cast<NodeIndex>(description.nodes.size()));
      const double part = static_cast<double>(k) / parts;
      description.nodes.push_back({from.name + "_" + to.name + "_" + std::to_string(k),
                                   from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
                                   0, false});
    }
    std::vector<NodeIndex> along = found->second;
    if (lane.from != ends.first) std::reverse(along.begin(), along.end());
    along.push_back(lane.to);
    NodeIndex before = lane.from;
    for (const NodeIndex node : along) {
      description.lanes.push_back({before, node, lane.lane_class, std::nullopt, lanes::kNone});
      before = node;
    }
  }
  return LaneNetwork(std::move(description));
}

}  // namespace rubicon::traffic
