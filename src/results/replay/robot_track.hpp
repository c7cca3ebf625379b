#pragma once

#include <vector>

#include "src/results/replay/machine.hpp"
#include "src/results/replay/task_run.hpp"

namespace rubicon::replay {

/// What hangs on a tool: a component, or the load of a short plan (-1).
struct Hanging {
  int component = -1;
  math::Pose X_TO = math::Pose::Identity();  ///< as it begins to hang so
  /// By how much people turn it meanwhile about the vertical through the tool's origin, evenly.
  double turn_deg = 0;
};

/// One stretch of a robot's time: a step, or standing still. While it lasts its values run in a
/// straight line, and the same hangs on its tool.
struct Leg {
  Ticks from = 0;
  Ticks to = 0;
  std::vector<double> q0;
  std::vector<double> q1;  ///< turns not reduced; empty: it stands at q0
  int hanging = -1;        ///< index into RobotTrack::loads

  bool moves() const { return !q1.empty(); }
};

/// A robot through the whole plan, without a gap.
struct RobotTrack {
  std::vector<Leg> legs;
  std::vector<Hanging> loads;
};

/// Follows a robot through its tasks (those that happened), in the order in which they began, until
/// the end of the plan. `carries`: the load of a short plan hangs on it from the first.
RobotTrack follow_robot(const Machine& machine, const std::vector<const TaskRun*>& runs,
                        bool carries, Ticks until);

}  // namespace rubicon::replay
