#include "src/fleets/layout/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "src/fleets/lanes/shortest_way.hpp"

namespace rubicon::layout {

namespace {

using lanes::LaneIndex;
using lanes::LaneNetwork;
using lanes::NetworkDescription;
using lanes::NodeIndex;
using lanes::WaysFrom;

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

NetworkDescription described(const Arrangement& made, const Sizes& sizes) {
  NetworkDescription description;
  description.classes = {{"aisle", sizes.aisle_speed, sizes.width(false), 1},
                         {"cross", sizes.cross_speed, sizes.width(true), 1}};
  description.nodes = made.nodes;
  for (std::size_t i = 0; i < description.nodes.size(); ++i) {
    description.nodes[i].name = fmt::format("{}", i);
  }
  description.lanes = made.lanes;
  return description;
}

NetworkDescription reversed(NetworkDescription description) {
  for (lanes::Lane& lane : description.lanes) std::swap(lane.from, lane.to);
  return description;
}

lanes::WayOptions options_of(const Sizes& sizes) {
  lanes::WayOptions options;
  if (sizes.vehicle_speed > 0) options.vehicle_speed = sizes.vehicle_speed;
  return options;
}

/// Only what is kept, with new numbers.
Arrangement only(const Arrangement& made, const std::vector<bool>& keep) {
  Arrangement kept;
  kept.aisles = made.aisles;
  std::vector<NodeIndex> number(made.nodes.size(), lanes::kNone);
  for (std::size_t i = 0; i < made.nodes.size(); ++i) {
    if (!keep[i]) continue;
    number[i] = static_cast<NodeIndex>(kept.nodes.size());
    kept.nodes.push_back(made.nodes[i]);
    kept.is_crossing.push_back(made.is_crossing[i]);
  }
  for (lanes::Lane lane : made.lanes) {
    lane.from = number[at(lane.from)];
    lane.to = number[at(lane.to)];
    if (lane.from != lanes::kNone && lane.to != lanes::kNone) kept.lanes.push_back(lane);
  }
  for (Module module : made.modules) {
    module.stop = number[at(module.stop)];
    if (module.stop != lanes::kNone) kept.modules.push_back(module);
  }
  return kept;
}

/// Sums over the quickest ways from a gate to all modules (or back, on the reversed network).
class TripSums {
 public:
  explicit TripSums(const std::vector<Module>& modules) : modules_(modules) {}

  void add(const LaneNetwork& network, NodeIndex gate, const lanes::WayOptions& options) {
    const WaysFrom ways = lanes::ways_from(network, gate, options);
    const auto nodes = at(network.node_count());
    held_.resize(nodes, 0);
    std::vector<int> trips(nodes, 0);
    for (const Module& module : modules_) {
      ++trips[at(module.stop)];
      time_ += seconds(ways.weight[at(module.stop)]);
    }
    // From the far ends of the ways: how many go over each lane.
    std::vector<std::size_t> order(nodes);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return ways.weight[a] > ways.weight[b]; });
    for (const std::size_t node : order) {
      const LaneIndex lane = ways.last[node];
      if (lane == lanes::kNone || trips[node] == 0) continue;
      const auto before = at(network.lane(lane).from);
      const double held = trips[node] * seconds(network.time(lane, options.vehicle_speed));
      trips[before] += trips[node];
      held_[before] += held;
      held_[node] += held;
    }
  }

  double time() const { return time_; }
  double longest_held() const { return *std::max_element(held_.begin(), held_.end()); }

 private:
  static double seconds(lanes::Nanoseconds time) { return static_cast<double>(time) * 1e-9; }

  const std::vector<Module>& modules_;
  std::vector<double> held_;  ///< s, by node
  double time_ = 0;
};

}  // namespace

Layout judge(const Choice& choice, Arrangement made, const Sizes& sizes) {
  Layout layout;
  layout.choice = choice;
  layout.aisles = made.aisles;
  if (!made.gates_joined || made.lanes.empty()) return layout;
  const lanes::WayOptions options = options_of(sizes);
  const int gates = made.gates;
  {
    // What one gate reaches, and is reached from, is joined to all else of this kind.
    const NetworkDescription all = described(made, sizes);
    const WaysFrom out = lanes::ways_from(LaneNetwork(all), 0, options);
    const WaysFrom back = lanes::ways_from(LaneNetwork(reversed(all)), 0, options);
    std::vector<bool> keep;
    for (std::size_t i = 0; i < made.nodes.size(); ++i) {
      keep.push_back(out.weight[i] < lanes::kNoWay && back.weight[i] < lanes::kNoWay);
    }
    if (std::find(keep.begin(), keep.begin() + gates, false) != keep.begin() + gates) return layout;
    made = only(made, keep);
  }
  if (made.modules.empty()) return layout;
  layout.network = described(made, sizes);
  layout.modules = made.modules;
  const LaneNetwork there(layout.network);
  const LaneNetwork back(reversed(layout.network));
  TripSums sums(layout.modules);
  for (NodeIndex gate = 0; gate < gates; ++gate) {
    sums.add(there, gate, options);
    sums.add(back, gate, options);
  }
  const double trips = static_cast<double>(layout.modules.size()) * gates;
  layout.mean_trip = sums.time() / trips;
  layout.trips_per_hour = 3600 * trips / sums.longest_held();
  std::set<std::pair<NodeIndex, NodeIndex>> counted;
  for (LaneIndex lane = 0; lane < there.lane_count(); ++lane) {
    const auto ends = std::minmax(there.lane(lane).from, there.lane(lane).to);
    if (counted.insert(ends).second) layout.lane_metres += there.length(lane);
  }
  int crossings = 0;
  int stops = 0;
  for (std::size_t i = at(gates); i < made.nodes.size(); ++i) {
    layout.network.nodes[i].name = made.is_crossing[i] ? fmt::format("crossing_{}", ++crossings)
                                                       : fmt::format("stop_{}", ++stops);
  }
  return layout;
}

}  // namespace rubicon::layout
