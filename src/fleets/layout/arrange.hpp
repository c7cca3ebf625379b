#pragma once

#include <string_view>
#include <vector>

#include "src/fleets/lanes/lane_network.hpp"
#include "src/fleets/layout/hall.hpp"

namespace rubicon::layout {

/// What is given.
struct Sizes {
  double length = 2.4;       ///< m, of a module along its aisle
  double depth = 1.2;        ///< m, across it
  double height = 2;         ///< m
  double lane = 3;           ///< m, the width of a lane of an aisle, which has one or two
  double cross_lane = 0;     ///< m, of a cross aisle, and to gates; 0: as in aisles
  double spacing = 3;        ///< m, from node to node in an aisle at least
  double aisle_speed = 1;    ///< m/s
  double cross_speed = 1;    ///< m/s, in cross aisles and to gates
  double vehicle_speed = 0;  ///< m/s at most; 0: as fast as the lanes

  /// m, of a lane of an aisle or a cross aisle.
  double width(bool is_cross) const { return is_cross && cross_lane != 0 ? cross_lane : lane; }
};

/// How lanes lie in aisles and cross aisles.
enum class Ways {
  one_way,   ///< one lane, and the next aisle goes back
  shared,    ///< one lane for both directions
  two_lanes  ///< two lanes side by side, on the right
};
std::string_view name_of(Ways ways);

/// What is chosen.
struct Choice {
  bool along_y = false;  ///< rows lie along y, else along x
  Ways ways = Ways::one_way;
  int cross_aisles = 0;  ///< between those along the walls
  double shift = 0;      ///< m, of the first aisle from where the hall begins
};

/// A place to store, and the node from which it is served.
struct Module {
  Rectangle box;
  lanes::NodeIndex stop = lanes::kNone;
};

/// Rows and lanes as a choice has them, also those that no gate is joined to.
struct Arrangement {
  std::vector<lanes::Node> nodes;  ///< the gates first, in their order; then without names
  std::vector<bool> is_crossing;   ///< by node
  std::vector<lanes::Lane> lanes;  ///< class 0 in aisles, class 1 elsewhere
  std::vector<Module> modules;
  int gates = 0;
  int aisles = 0;
  bool gates_joined = true;  ///< to a lane, each of them
};

/// How far it is from one aisle to the next.
double period_of(const Sizes& sizes, Ways ways);

/// Aisles lie a period apart, two rows between them back to back, the last rows single. Cross
/// aisles lie along walls and evenly spaced between. Modules stand one beside the other in their
/// row, and leave out what is in their way. `space` has to be turned if rows lie along y.
Arrangement arrange(const HallSpace& space, const Sizes& sizes, const Choice& choice);

}  // namespace rubicon::layout
