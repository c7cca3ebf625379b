#pragma once

#include <memory>
#include <vector>

#include "src/motion/guides/roadmap.hpp"

namespace rubicon::guides {

class RepairedLattice;

/// A tree of configurations whose root is the goal: each leads on to its parent.
struct GoalTree {
  std::vector<Point> points;  ///< the goal first
  std::vector<int> parents;   ///< of the goal -1; a parent stands before its children

  /// Leaves out a node and all that lead on to it; it is not the goal.
  void trim(int node);
};

/// What planners of whole ways keep from one way to the next, for one goal. A value: what copies
/// share does not change.
struct PlanMemory {
  RoadmapMemory roadmap;                           ///< prm
  std::shared_ptr<const RepairedLattice> lattice;  ///< dstar_lite
  std::shared_ptr<const GoalTree> tree;            ///< drrt
};

}  // namespace rubicon::guides
