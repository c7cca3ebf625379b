#pragma once

#include <vector>

#include "src/results/verify/replay/task_run.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"
#include "src/results/verify/schedule/working_hours.hpp"

namespace rubicon::verify {

/// The critical path: it ends with a task that finishes last and begins with the plan; each task
/// says in its sentence what it waited for, and that is the task before it, by a link of the plan
/// and its lag, or a robot or crew that both have, given back at that moment.
void check_critical(const Trace& trace, const std::vector<TaskRun>& runs, const WorkingHours& hours,
                    const ScheduleJson& schedule, Faults& faults);

}  // namespace rubicon::verify
