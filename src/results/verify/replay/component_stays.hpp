#pragma once

#include <vector>

#include "src/results/verify/replay/robot_track.hpp"

namespace rubicon::verify {

/// A component that stands somewhere for some time.
struct Stay {
  int component = -1;
  Pose X_WO = Pose::Identity();
  Ticks from = 0;
  Ticks to = 0;
};

/// Where the components stand through the plan (its end is `until`), from what the robots did to
/// them (`events`) and what tasks removed. Reports what is taken where it does not stand, put down
/// where it does not hang, left elsewhere than its goal, or taken, put down and removed out of
/// turn.
std::vector<Stay> component_stays(const Trace& trace, const std::vector<TaskRun>& runs,
                                  const std::vector<RobotTrack>& tracks,
                                  std::vector<LoadEvent> events, Ticks until, Faults& faults);

}  // namespace rubicon::verify
