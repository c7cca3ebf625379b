#pragma once

#include <vector>

#include "src/fleets/lanes/lane_network.hpp"

namespace rubicon::traffic {

using lanes::LaneIndex;
using lanes::LaneNetwork;
using lanes::NodeIndex;

/// What vehicles cannot use at the same time though they share no node: lanes that cross or lie
/// near to each other, nodes beside a lane, and nodes beside each other.
struct Nearness {
  std::vector<std::vector<LaneIndex>> lanes_by_lane;
  std::vector<std::vector<NodeIndex>> nodes_by_lane;
  std::vector<std::vector<LaneIndex>> lanes_by_node;
  std::vector<std::vector<NodeIndex>> nodes_by_node;
};

/// Of discs of this diameter (m) whose middles keep to the nodes and the straight lines between
/// them.
Nearness nearness_of(const LaneNetwork& network, double diameter);

/// The same network with its lanes cut into pieces of the same length, of `piece` (m) at least, so
/// that vehicles may stop and follow within a lane. The nodes of the network keep their numbers;
/// both directions of a lane have the same new ones. Its lanes have to be straight. Throws
/// std::invalid_argument for a piece that is not above 0.
LaneNetwork divided(const LaneNetwork& network, double piece);

}  // namespace rubicon::traffic
