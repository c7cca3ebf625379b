#pragma once

#include <optional>
#include <vector>

#include "src/results/verify/replay/task_run.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"

namespace rubicon::verify {

/// The cold joints of a task that covers a floor: places along the borders of its strips are looked
/// at one by one, each with the times at which the tool passed on either side of it. What the trace
/// tells must be cold and as old as told, and what is cold must be told.
void check_joints(const Trace& trace, const TaskRun& run, Faults& faults);

/// The same of schedule.json: the joints that the trace tells, how long they are together, and the
/// oldest of all.
void check_joint_rows(const Trace& trace, const std::vector<TaskRun>& runs,
                      const std::vector<ScheduleRow>& rows, Faults& faults);

}  // namespace rubicon::verify
