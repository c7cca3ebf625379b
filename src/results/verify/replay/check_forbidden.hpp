#pragma once

#include "src/results/verify/replay/robot_track.hpp"
#include "src/results/verify/replay/site_parts.hpp"
#include "src/results/verify/replay/task_run.hpp"

namespace rubicon::verify {

/// Where a robot may not stand, as full traces tell it about what its guide searched through:
/// ranges of the robot, and of each grid some of the cells that are told as free. In their middles
/// the robot and what hangs on it must not come deep into what stands then, nor into its own parts.
/// That a cell is rightly told as forbidden is not looked at: there are more reasons than contact.
void check_forbidden(const Trace& trace, const std::vector<TaskRun>& runs,
                     const std::vector<RobotTrack>& tracks, const SiteParts& site, Faults& faults);

}  // namespace rubicon::verify
