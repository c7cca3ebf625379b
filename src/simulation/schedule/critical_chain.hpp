#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/simulation/schedule/network.hpp"

namespace rubicon::schedule {

/// One link of the critical path: a task, and what it waited for.
struct ChainStep {
  int task = -1;
  bool work_counts = false;  ///< the task's own work is part of what makes the whole so long
  Held held = Held::plan_start;
  int link = -1;                   ///< held by a link: index into `after`
  int resource = -1;               ///< held by a resource: index
  int task_before = -1;            ///< whose event held it, the step before; -1 for the first step
  bool at_finish = false;          ///< its finish was held, not its start
  bool midway = false;             ///< it stood still after its start
  bool missed = false;             ///< it would have stood still, and waited for a shift instead
  bool could_start = false;        ///< that let it start, and a machine stood in its zone
  bool kept = false;               ///< the resource was kept for others after the task before
  bool repaired = false;           ///< the machine was repaired after the task before
  bool given_back_midway = false;  ///< the task before let go before its own finish
  std::optional<Parking> parking = {};  ///< of the task before
  Ticks wanted = 0;                     ///< when what held it let go
  Ticks out_of_shift = 0;               ///< from then to the begin of the next shift
  Ticks shift_waits = 0;                ///< for shifts after that, on its way
  Ticks first_gain =
      0;  ///< let go less than this sooner, it comes through its first shift no sooner
  std::string thing = {};  ///< with a timetable, for which it waited
  bool delayed = false;    ///< that came later than its timetable says
};

/// What, if shortened, shortens the whole: from the task that finishes last (the first in the file
/// of several) back along what held each task, then in order of time. A task is part of the chain
/// with its work
/// (`work_counts`) or, where a link leads from or to its other end, as a point in time only.
/// Empty for a network without tasks. Linear in tasks.
std::vector<ChainStep> critical_chain(const Network& network, const NetworkTimes& times);

/// Why a task started when it did: the step for its start, with its own work counted.
ChainStep start_step(const Network& network, int task, const TaskTimes& times);

/// A sentence for the step: "b starts after a (SS + 2 h), 15 h later: the next shift".
std::string text_of(const Network& network, const ChainStep& step);

}  // namespace rubicon::schedule
