#pragma once

#include "src/fleets/lanes/lane_network.hpp"

namespace rubicon::lanes {

/// The warehouse of the Blackmon paper (Figures 1 to 4). Corridors A, B, C ... lie one below the
/// other. In each, modules 1, 3, 5 ... are met on the lane that goes one way, modules 2, 4, 6 ...
/// on the lane that goes back; with five rows module n is across from module 11 - n. A node Xn is
/// the entrance corner of module n in corridor X, XnX(n+2) its exit corner. Corridors are joined by
/// travelways between the rows, and by a highway all round with a gate at each end of a corridor.
///
/// The paper prints times and not lengths: a lane is as long as its class goes in its time.
/// Places of nodes are drawn for modules of 18 m by 18 m and lanes of 4 m.
struct WarehouseQuery {
  int corridors = 3;   ///< 1 to 26
  int rows = 5;        ///< modules along one side of a corridor
  double along = 40;   ///< s, from the entrance corner of a module to its exit corner
  double inside = 20;  ///< s, each leg inside an intersection
  double across = 20;  ///< s, from one corridor to the next
  double entry = 30;   ///< s, from a gate to the first module, by the node between (X, XX1, X1)
  double hop = 15;     ///< s, on the highway from gate to gate
  double round = 75;   ///< s, on the highway from the near side to the far side
  /// The text goes from gate A straight to A1: the node AA1 is left out. Costs are the same.
  bool middle_node_at_first_gate = false;
  /// Gates AA, BB, ... at the far ends, and the highway round the warehouse.
  bool far_gates = true;
  LaneClass highway{"highway", 3, 4, 1};
  LaneClass freeway{"freeway", 2, 4, 1};
  LaneClass alley{"alley", 0.45, 4, 1};
};

/// The description of its network: gates, then each corridor's nodes. Throws std::invalid_argument
/// for counts that are out of range and times that are not above 0.
NetworkDescription warehouse(const WarehouseQuery& query = {});

}  // namespace rubicon::lanes
