#pragma once

#include "src/fleets/layout/arrange.hpp"

namespace rubicon::layout {

/// A layout that works, and what it is worth.
struct Layout {
  Choice choice;
  lanes::NetworkDescription network;  ///< class 0 aisles, class 1 cross aisles; gates first
  std::vector<Module> modules;        ///< those that a vehicle can reach from every gate, and leave
  int aisles = 0;
  /// s: from a gate to a module and from there to a gate by the quickest ways; the mean over all
  /// modules and all pairs of gates.
  double mean_trip = 0;
  /// An upper bound: a vehicle holds a node from when it leaves the node before until it has
  /// reached the node after, and the node that is held longest lets no more trips through. Time to
  /// load and unload comes on top.
  double trips_per_hour = 0;
  double lane_metres = 0;  ///< a shared lane counts once
};

/// Leaves out what cannot be reached from all gates, or not be left. Without modules if a gate has
/// no way to another.
Layout judge(const Choice& choice, Arrangement made, const Sizes& sizes);

}  // namespace rubicon::layout
