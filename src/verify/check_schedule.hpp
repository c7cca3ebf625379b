#pragma once

#include <vector>

#include "src/verify/accounts.hpp"
#include "src/verify/check_waits.hpp"
#include "src/verify/schedule_row.hpp"
#include "src/verify/task_run.hpp"

namespace rubicon::verify {

/// Compares a schedule with what the trace tells of the same tasks.
void check_rows(const Trace& trace, const std::vector<TaskRun>& runs,
                const std::vector<TaskAccount>& accounts, const WaitCheck& waits,
                const std::vector<ScheduleRow>& rows, ResultFile file, Faults& faults);

/// Compares the process time: the end of the last task of the plan that was done.
void check_process_time(const std::vector<TaskRun>& runs, Ticks process_time, Faults& faults);

}  // namespace rubicon::verify
