#pragma once

#include "src/results/verify/replay/moving_path.hpp"
#include "src/results/verify/replay/site_parts.hpp"

namespace rubicon::verify {

/// What was looked at.
struct ContactCounts {
  long steps = 0;
  long pairs = 0;  ///< of solids that came near each other
};

/// Looks for contact through the whole plan: every step of every robot and its load against all
/// that stands meanwhile, against its own parts, and against every other robot and its load at the
/// same time; robots that stand in the zone of a task; what moves by a timetable against all robots
/// and all that stands.
ContactCounts check_contacts(const Trace& trace, const std::vector<TaskRun>& runs,
                             const std::vector<RobotTrack>& tracks, const SiteParts& site,
                             const std::vector<MovingPath>& movings, Faults& faults);

}  // namespace rubicon::verify
