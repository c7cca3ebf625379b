#pragma once

#include <vector>

#include "src/results/verify/replay/site_parts.hpp"

namespace rubicon::verify {

/// Adds what trucks tipped to what must not be met: each cell of a heap as a column that is so high
/// while it was.
void add_heaps(const Trace& trace, const std::vector<TaskRun>& runs, Ticks until,
               std::vector<Obstacle>& obstacles);

/// Looks at what trucks with bodies hauled: that each stood where it was loaded while the buckets
/// of its load were emptied, took no more than it holds, and tipped all of it where it may; that
/// every bucket went away with one; and that heaps are as much as was tipped, and no steeper than
/// loose soil lies.
void check_hauled_soil(const Trace& trace, const std::vector<TaskRun>& runs,
                       const std::vector<RobotTrack>& tracks, const SiteParts& site,
                       Faults& faults);

}  // namespace rubicon::verify
