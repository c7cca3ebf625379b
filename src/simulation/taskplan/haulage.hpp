#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "src/earth/soil/terrain.hpp"
#include "src/motion/math/pose.hpp"
#include "src/simulation/schedule/ticks.hpp"
#include "src/simulation/site/workspace.hpp"

namespace rubicon::taskplan {

/// Where the trucks of a task that digs are loaded, and where they wait for that.
struct LoadingPlace {
  bool is_open = false;  ///< it digs
  bool is_over = false;  ///< it has dug all
  /// Tasks that haul, by the places that they have: first that to be loaded; -1: free.
  std::vector<int> claims;
  std::set<int> coming;  ///< tasks that are on their way to the last place of the queue
  int standing = -1;     ///< that is loaded
};

/// A truck at a task that digs.
struct TruckLoad {
  int dig = -1;
  soil::CubicMillimetres volume = 0;  ///< bank volume on it
  bool is_full = false;               ///< no whole bucket goes on it any more, or all is dug
  schedule::Ticks arrived = 0, began = 0, loaded = 0;
};

/// Soil that is tipped on an earth.
struct HeapLedger {
  std::shared_ptr<const soil::Terrain> ground;  // shared: it is large, and never changed
  soil::CubicMillimetres bank = 0, loose = 0;   ///< that was tipped
  std::int64_t placed = 0;                      ///< mm of cells that lie there
};

/// A place to tip that a task which hauls has.
struct TipClaim {
  math::Pose X_WL;  ///< of the plan
  /// What its truck covered when it had tipped: the place is free when it has left that.
  std::optional<site::PlanRegion> stood;
};

/// What tasks that dig and tasks that haul know of each other. A value: a run that goes back takes
/// an earlier copy.
struct Haulage {
  std::map<int, LoadingPlace> places;  ///< by task that digs
  std::map<int, TruckLoad> trucks;     ///< by task that hauls
  std::map<int, int> idle;  ///< tasks that know no place to go to: the robot they stay with, or -1
  std::map<int, HeapLedger> heaps;  ///< by earth
  std::map<int, TipClaim> tips;     ///< by task that hauls, also one that is over
  /// Of places: so many cells away from them, from where loads fall, there was room at last.
  std::vector<std::pair<math::Pose, int>> rows;
};

}  // namespace rubicon::taskplan
