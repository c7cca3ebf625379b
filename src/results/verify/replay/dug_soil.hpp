#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <vector>

#include "src/results/verify/replay/site_parts.hpp"

namespace rubicon::verify {

/// Adds soil that robots dug to what must not be met: each of its cells as a column that is so high
/// while it was. The components that these are.
std::set<int> add_dug_soil(const Trace& trace, const std::vector<TaskRun>& runs,
                           const std::vector<Stay>& stays, std::vector<Obstacle>& obstacles);

/// When the tool of a robot may be in the soil that it digs: while a bucket is filled.
class Cuts {
 public:
  Cuts(const Trace& trace, const std::vector<TaskRun>& runs);
  bool allow(const Leg& leg, int component) const;

 private:
  struct Dig {
    int component = -1;
    std::vector<std::pair<Ticks, Ticks>> times;
  };
  std::vector<Dig> digs_;  ///< by run
};

/// Time between two moments in which all of these calendars work.
using TimeWorked = std::function<Ticks(const std::vector<int>& calendars, Ticks from, Ticks to)>;

/// Looks at what robots dug: that each bucket took from cells of its pit what it told, no more than
/// it holds, where the tool was, and was emptied where it should; that the pit is dug to its bottom
/// and no farther; that trucks were there to be loaded, and drove as long as the trace tells where
/// it does.
void check_dug_soil(const Trace& trace, const std::vector<TaskRun>& runs,
                    const std::vector<RobotTrack>& tracks, const SiteParts& site,
                    const TimeWorked& time_worked, Faults& faults);

/// A bucket of a robot that digs, when it came to where it is emptied.
struct EmptiedBucket {
  Ticks time = 0;
  std::int64_t volume = 0;
};
/// Those of the robot of a run, by its own kinematics.
std::vector<EmptiedBucket> emptied_buckets(const Trace& trace, const TaskRun& run,
                                           const Mechanism& mechanism);

}  // namespace rubicon::verify
