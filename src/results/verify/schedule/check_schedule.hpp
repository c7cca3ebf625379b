#pragma once

#include <vector>

#include "src/results/verify/replay/task_run.hpp"
#include "src/results/verify/schedule/accounts.hpp"
#include "src/results/verify/schedule/check_costs.hpp"
#include "src/results/verify/schedule/check_waits.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"

namespace rubicon::verify {

/// Compares a schedule with what the trace tells of the same tasks.
void check_rows(const Trace& trace, const std::vector<TaskRun>& runs,
                const std::vector<TaskAccount>& accounts, const Costs& costs,
                const WaitCheck& waits, const std::vector<ScheduleRow>& rows, ResultFile file,
                Faults& faults);

/// Compares the process time: the end of the last task of the plan that was done.
void check_process_time(const std::vector<TaskRun>& runs, Ticks process_time, Faults& faults);

}  // namespace rubicon::verify
