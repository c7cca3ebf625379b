#include "src/fleets/lanes/covering_walk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace rubicon::lanes {
namespace {

// An edge is two darts, 2e from a to b and 2e + 1 back; a loop has both at its node.
class Explorer {
 public:
  Explorer(const Multigraph& graph, std::int32_t start)
      : graph_(graph),
        start_(start),
        first_(static_cast<std::size_t>(graph.nodes) + 1, 0),
        darts_(2 * graph.edges.size()),
        arrived_by_(static_cast<std::size_t>(graph.nodes), kNone),
        visited_(static_cast<std::size_t>(graph.nodes), false),
        unused_(static_cast<std::size_t>(graph.nodes), 0),
        left_by_(2 * graph.edges.size(), false) {
    for (std::size_t dart = 0; dart < darts_.size(); ++dart) ++first_[start_of(dart) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    next_.assign(first_.begin(), first_.end() - 1);
    std::vector<std::size_t> place = next_;
    for (std::size_t dart = 0; dart < darts_.size(); ++dart) {
      darts_[place[start_of(dart)]++] = static_cast<std::int32_t>(dart);
    }
    for (const Multigraph::Edge& edge : graph.edges) {
      ++unused_[static_cast<std::size_t>(edge.a)];
      if (edge.a != edge.b) ++unused_[static_cast<std::size_t>(edge.b)];
    }
  }

  std::vector<WalkStep> walk(Exploration exploration) {
    std::vector<WalkStep> steps;
    std::int32_t now = start_;
    visit(now, kNone);
    while (true) {
      const bool go_home = exploration == Exploration::kFraenkel && unfinished_ == 0;
      const std::int32_t dart = go_home ? kNone : next_dart(now);
      const std::int32_t by = dart != kNone ? dart : home_dart(now);
      if (by == kNone) return steps;
      use(by);
      const auto to = static_cast<std::int32_t>(start_of(other_end(by)));
      steps.push_back({by / 2, now, to});
      if (!visited_[static_cast<std::size_t>(to)]) visit(to, by);
      now = to;
    }
  }

 private:
  static std::size_t other_end(std::int32_t dart) { return static_cast<std::size_t>(dart) ^ 1; }
  std::size_t start_of(std::size_t dart) const {
    const Multigraph::Edge& edge = graph_.edges[dart / 2];
    return static_cast<std::size_t>(dart % 2 == 0 ? edge.a : edge.b);
  }

  // The way back along which the node was first reached; none at the start.
  std::int32_t home_dart(std::int32_t node) const {
    const std::int32_t by = arrived_by_[static_cast<std::size_t>(node)];
    return by == kNone ? kNone : static_cast<std::int32_t>(other_end(by));
  }

  // The first dart here that was not yet left by, but for the way home.
  std::int32_t next_dart(std::int32_t node) {
    const auto here = static_cast<std::size_t>(node);
    const std::int32_t home = home_dart(node);
    for (std::size_t& i = next_[here]; i < first_[here + 1]; ++i) {
      if (darts_[i] != home && !left_by_[static_cast<std::size_t>(darts_[i])]) return darts_[i];
    }
    return kNone;
  }

  void visit(std::int32_t node, std::int32_t by) {
    visited_[static_cast<std::size_t>(node)] = true;
    arrived_by_[static_cast<std::size_t>(node)] = by;
    if (unused_[static_cast<std::size_t>(node)] > 0) ++unfinished_;
  }

  void use(std::int32_t dart) {
    const auto one = static_cast<std::size_t>(dart);
    const bool fresh = !left_by_[one] && !left_by_[other_end(dart)];
    left_by_[one] = true;
    if (!fresh) return;
    const std::size_t a = start_of(one);
    const std::size_t b = start_of(other_end(dart));
    finish_one(a);
    if (a != b) finish_one(b);
  }

  void finish_one(std::size_t node) {
    if (--unused_[node] == 0 && visited_[node]) --unfinished_;
  }

  const Multigraph& graph_;
  std::int32_t start_;
  std::vector<std::size_t> first_;  // by node: its darts in darts_
  std::vector<std::size_t> next_;   // by node: the first dart that may still be left by
  std::vector<std::int32_t> darts_;
  std::vector<std::int32_t> arrived_by_;
  std::vector<bool> visited_;
  std::vector<std::int32_t> unused_;  // by node: edges that nobody went along
  std::vector<bool> left_by_;         // by dart
  std::int32_t unfinished_ = 0;       // visited nodes with unused edges
};

}  // namespace

std::string_view name_of(Exploration exploration) {
  return exploration == Exploration::kTarry ? "tarry" : "fraenkel";
}

std::vector<WalkStep> covering_walk(Exploration exploration, const Multigraph& graph,
                                    std::int32_t start) {
  const auto is_node = [&graph](std::int32_t i) { return i >= 0 && i < graph.nodes; };
  if (!is_node(start)) {
    throw std::invalid_argument(fmt::format("walk: there is no node number {}", start));
  }
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    if (!is_node(graph.edges[i].a) || !is_node(graph.edges[i].b)) {
      throw std::invalid_argument(fmt::format("walk: edge {} has an unknown node", i));
    }
  }
  return Explorer(graph, start).walk(exploration);
}

Travelways travelways_of(const LaneNetwork& network) {
  Travelways result;
  result.graph.nodes = network.node_count();
  for (LaneIndex i = 0; i < network.lane_count(); ++i) {
    const Lane& lane = network.lane(i);
    const LaneIndex back = network.find_lane(lane.to, lane.from);
    if (back != kNone && back < i) continue;
    result.graph.edges.push_back({lane.from, lane.to});
    result.lane.push_back(i);
  }
  return result;
}

}  // namespace rubicon::lanes
