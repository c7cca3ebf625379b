#pragma once

#include <vector>

#include "src/results/verify/replay/task_run.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"
#include "src/results/verify/schedule/working_hours.hpp"

namespace rubicon::verify {

/// Breakdowns of machines: whether each comes when the machine has worked as long as it was good
/// for, at the first place where nothing hangs on it; whether it stands until it is repaired, for
/// as long as its law allows, in its working hours.
void check_breakdowns(const Trace& trace, const std::vector<TaskRun>& runs,
                      const WorkingHours& hours, Faults& faults);

/// Days that the weather took, as the trace tells them: drawn once more.
void check_lost_days(const Trace& trace, const std::vector<TaskRun>& runs,
                     const WorkingHours& hours, Faults& faults);

/// Whether schedule.json tells of both what the trace does.
void check_chance(const Trace& trace, const ScheduleJson& schedule, Faults& faults);

}  // namespace rubicon::verify
