#pragma once

#include <optional>
#include <vector>

#include "src/results/verify/replay/task_run.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"

namespace rubicon::verify {

/// Whether tasks that dig take as long, and tip as much, as their rounds do. Where each duration is
/// certain the rounds are gone through again, truck by truck; where some were drawn, the time and
/// the loads are held against what the least durations allow. The same of how long trucks drive and
/// are served, where the trace tells it.
void check_digs(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults);

/// Whether what schedule.json and loads.csv tell of digs is what the rounds give: volumes, loads,
/// times, queues, and what a m3 costs. Of rounds whose durations were drawn the queues are held
/// against each other only. `loads`: nothing where there is no such file.
void check_dig_rows(const Trace& trace, const std::vector<TaskRun>& runs,
                    const std::vector<ScheduleRow>& rows,
                    const std::optional<std::vector<LoadRow>>& loads, Faults& faults);

}  // namespace rubicon::verify
