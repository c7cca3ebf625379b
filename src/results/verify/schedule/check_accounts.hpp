#pragma once

#include <optional>
#include <vector>

#include "src/results/verify/schedule/accounts.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"

namespace rubicon::verify {

/// Compares the split of the time of a row with the account of its run: the parts add up to the
/// whole, and none is less than its records tell.
void check_split(const TaskRun& run, const TaskAccount& account, const ScheduleRow& row,
                 ResultFile file, Faults& faults);

/// Compares what schedule.json tells of robots and crews, but for money, with the accounts of the
/// tasks.
void check_uses(const Trace& trace, const std::vector<TaskRun>& runs,
                const std::vector<TaskAccount>& accounts, const WorkingHours& hours,
                const ScheduleJson& schedule, Faults& faults);

}  // namespace rubicon::verify
