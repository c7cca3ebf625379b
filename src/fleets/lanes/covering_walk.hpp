#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "src/fleets/lanes/lane_network.hpp"

namespace rubicon::lanes {

/// Ways that may be walked in both directions, between nodes numbered from 0. Several may join the
/// same two nodes, and both ends may be one node (a loop).
struct Multigraph {
  struct Edge {
    std::int32_t a = 0;
    std::int32_t b = 0;
  };
  std::int32_t nodes = 0;
  std::vector<Edge> edges;
};

/// How to explore a network of which only the ways at the present node are seen.
enum class Exploration {
  /// Leave a node by a way not yet left by; by the way of the first arrival only when no other is
  /// left. G. Tarry, "Le probleme des labyrinthes", 1895; the survey, section on graph traversal.
  kTarry,
  /// The same, but as soon as no node that was visited has an unused way, straight back by the ways
  /// of first arrival. A. S. Fraenkel 1970, 1971; the survey, as above. Its counter is taken to be
  /// the number of visited nodes that have an unused way: a step may lower it by two, so the
  /// survey's formulas for it cannot hold.
  kFraenkel,
};
std::string_view name_of(Exploration exploration);

/// A step of a walk along an edge.
struct WalkStep {
  std::int32_t edge = 0;
  std::int32_t from = 0;
  std::int32_t to = 0;
};

/// A closed walk that goes along each way that can be reached from its start. Tarry: each twice,
/// once in each direction, so 2|E| steps (a loop counts as two ends of one way and is walked
/// twice). Fraenkel: each once or twice. Of several ways that the rule allows the one with the
/// lowest number is taken. Takes time and memory in proportion to nodes and edges. Throws
/// std::invalid_argument for a start or an edge that names a node that is not there.
std::vector<WalkStep> covering_walk(Exploration exploration, const Multigraph& graph,
                                    std::int32_t start);

/// The travelways of a network for walkers who may use them in both directions: one edge for each
/// pair of nodes that a lane joins, in the order of their first lanes.
struct Travelways {
  Multigraph graph;
  std::vector<LaneIndex> lane;  ///< by edge: the first lane that it stands for
};
Travelways travelways_of(const LaneNetwork& network);

}  // namespace rubicon::lanes
