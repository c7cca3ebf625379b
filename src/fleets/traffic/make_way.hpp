#pragma once

#include <optional>
#include <vector>

#include "src/fleets/lanes/lane_network.hpp"

namespace rubicon::traffic {

using lanes::LaneIndex;
using lanes::LaneNetwork;
using lanes::NodeIndex;

/// A vehicle that stands and may be moved.
struct Mover {
  NodeIndex at = lanes::kNone;
  double width = 0;                   ///< m; narrower lanes are not for it
  NodeIndex wants = lanes::kNone;     ///< where it waits to go
  std::vector<NodeIndex> ahead = {};  ///< where its tasks lead that are not over
};

/// To bring the first of the movers to `wants`.
struct MakeWayQuery {
  const LaneNetwork* network = nullptr;
  std::vector<Mover> movers;
  std::vector<bool> taken;  ///< by node: held by somebody who is not to be moved
};

/// One vehicle over one lane.
struct Move {
  int mover = -1;
  LaneIndex lane = lanes::kNone;
  NodeIndex to = lanes::kNone;
};

/// Moves, one after the other, that bring the first to its goal: best first over the arrangements
/// of the movers, the fewest moves of those that a search of so many steps finds. Whoever makes way
/// goes only where lanes lead back to where it stands, and on to where it wants to go and its tasks
/// lead; if there are no such moves, only where lanes lead on to its tasks; if there are none
/// either, anywhere. Nothing: none were found.
std::optional<std::vector<Move>> make_way(const MakeWayQuery& query);

}  // namespace rubicon::traffic
