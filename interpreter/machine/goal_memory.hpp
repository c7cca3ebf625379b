#pragma once

#include <utility>
#include <vector>

#include "src/motion/robot/kinematics.hpp"

namespace rubicon::interpreter {

/// The goal frame that was solved last. A vehicle that waits begins its motion again whenever
/// another has moved, from the same place to the same goal: it is solved once. For motions of one
/// robot with one mounting, tolerance and clauses.
struct GoalMemory {
  std::vector<double> q;  ///< where the search began; empty: nothing is known
  std::vector<std::pair<int, double>> values;
  math::Pose X_WG = math::Pose::Identity();
  robot::GoalSolution solution;

  bool knows(const std::vector<double>& q_now, const std::vector<std::pair<int, double>>& beside,
             const math::Pose& X_WG_now) const {
    return !q.empty() && q == q_now && values == beside && X_WG.matrix() == X_WG_now.matrix();
  }
};

}  // namespace rubicon::interpreter
