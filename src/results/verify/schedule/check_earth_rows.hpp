#pragma once

#include <optional>
#include <vector>

#include "src/results/verify/replay/task_run.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"
#include "src/results/verify/schedule/working_hours.hpp"

namespace rubicon::verify {

/// Whether what schedule.json and loads.csv tell of robots that dig, and of trucks with bodies that
/// haul, is what the buckets and loads of the trace give: volumes, counts, times that are worked,
/// production, and what a m3 costs. Where in a cycle the bucket was, and when a truck came to the
/// queue, to the tip and had tipped, is held against the rest of its cycle only. `loads`: nothing
/// where there is no such file.
void check_earth_rows(const Trace& trace, const std::vector<TaskRun>& runs,
                      const WorkingHours& hours, const ScheduleJson& schedule,
                      const std::optional<std::vector<LoadRow>>& loads, Faults& faults);

}  // namespace rubicon::verify
