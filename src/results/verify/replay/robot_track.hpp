#pragma once

#include <vector>

#include "src/results/verify/input/mechanism.hpp"
#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// What hangs on a tool: a component, or the load of a short plan (-1).
struct Hanging {
  int component = -1;
  Pose X_TO = Pose::Identity();  ///< as it begins to hang so
  /// By how much people turn it meanwhile about the vertical through the tool's origin, evenly.
  double turn_deg = 0;
};

/// One stretch of a robot's time: a step, or standing still. While it lasts its values run
/// in a straight line, and the same hangs on its tool.
struct Leg {
  Ticks from = 0;
  Ticks to = 0;
  std::vector<double> q0;
  std::vector<double> q1;  ///< empty: it stands at q0
  int hanging = -1;        ///< index into RobotTrack::loads
  int run = -1;            ///< index into the runs; -1: before all of them
  int line = 0;

  bool moves() const { return !q1.empty(); }
};

/// A component taken or put down, with what the robot's own kinematics say of it; or removed.
struct LoadEvent {
  Ticks time = 0;
  int line = 0;
  int run = -1;
  LoadChange change;
  Pose X_WT = Pose::Identity();  ///< the tool then; not of remove
  int hung = -1;                 ///< of detach: what hung there, index into RobotTrack::loads
  int robot = -1;                ///< not of remove
};

/// A robot through the whole plan, without a gap.
struct RobotTrack {
  std::vector<Leg> legs;
  std::vector<Hanging> loads;
};

/// Follows one robot through its tasks (those that happened), in the order in which they began, and
/// reports every step that its rules do not allow, and values that jump. `until` is the end of the
/// plan.
RobotTrack follow_robot(const Trace& trace, const std::vector<TaskRun>& runs, int robot,
                        Ticks until, std::vector<LoadEvent>& loads, Faults& faults);

}  // namespace rubicon::verify
