#pragma once

#include <vector>

#include "src/results/verify/replay/task_run.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"
#include "src/results/verify/schedule/working_hours.hpp"

namespace rubicon::verify {

/// When tasks were due or planned by others, by how much they are late, and their floats, of a
/// schedule (`ends`: of all of it). A float must leave room: with every task at its latest, links
/// hold, nobody is taken who was not given back, and the end is where it was; and it is counted in
/// the working time of the task. Whether it could be more is not examined.
void check_plan_dates(const Trace& trace, const std::vector<TaskRun>& runs,
                      const WorkingHours& hours, const std::vector<ScheduleRow>& rows,
                      ResultFile file, Ticks ends, Faults& faults);

}  // namespace rubicon::verify
