#pragma once

#include <vector>

#include "src/results/verify/replay/site_parts.hpp"

namespace rubicon::verify {

/// Looks whether dynamic workspaces were kept apart, where the plan says so: what each of these
/// machines would have swept in the plan view until it stood, had it had to stop at the end of a
/// step, and where it stood. Machines that load each other are exempt.
void check_workspaces(const Trace& trace, const std::vector<TaskRun>& runs,
                      const std::vector<RobotTrack>& tracks, const SiteParts& site, Faults& faults);

}  // namespace rubicon::verify
