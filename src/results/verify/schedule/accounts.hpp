#pragma once

#include <vector>

#include "src/results/verify/replay/holds.hpp"
#include "src/results/verify/schedule/working_hours.hpp"

namespace rubicon::verify {

/// What a robot or crew gave to a task.
struct HeldTime {
  int resource = -1;
  Ticks held = 0;  ///< in its shifts, and steps after their end
  Ticks work = 0;  ///< crews: of that they worked
  Ticks off = 0;   ///< of `held`: under repair, or all stands out of somebody's shift
  int people = 1;
  Ticks overtime = 0;  ///< of `held`
  Ticks from = 0, to = 0;
};

/// Where the time of a task went after its start, and whom it had, added up from its records.
struct TaskAccount {
  Ticks steps = 0;         ///< of its robot
  Ticks thinking = 0;      ///< of its guides, which is part of these
  int foreseen = 0;        ///< times at which its way met what others are foreseen to sweep
  int rounds = 0;          ///< and a guide then led it
  Ticks script_waits = 0;  ///< `wait`s of the script: motion, or waiting for a machine
  int script_wait_count = 0;
  Ticks work = 0;  ///< in shifts
  Ticks held = 0;  ///< by a link, to its finish
  Ticks crew = 0;  ///< waiting for a crew
  Ticks machine = 0;
  Ticks shift = 0;
  Ticks repair = 0;  ///< of its robot
  std::vector<HeldTime> holds;
};

/// The account of each run; empty for what did not happen.
std::vector<TaskAccount> task_accounts(const Trace& trace, const std::vector<TaskRun>& runs,
                                       const WorkingHours& hours);

/// The share of a robot or crew that was held.
long double share_of(const Scene& scene, const HeldTime& held);
/// Money for a time at a rate per hour.
double cost_of(double rate, Ticks held);
/// The rate of a robot or crew per hour; none is 0.
double rate_of(const Scene& scene, int resource);
const SceneCharges& charges_of(const Scene& scene, int resource);

}  // namespace rubicon::verify
