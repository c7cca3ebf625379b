#pragma once

#include <vector>

#include "src/results/verify/input/fault.hpp"
#include "src/results/verify/input/record.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"

namespace rubicon::verify {

/// Whether names and other attributes of tasks and components are those of the trace, in both
/// schedules, and what a task covers.
void check_texts(const Scene& scene, const ScheduleJson& schedule, Faults& faults);
void check_texts(const Scene& scene, const std::vector<ScheduleRow>& rows_of_csv, Faults& faults);

/// Whether both schedules have the same floats.
void check_same_floats(const std::vector<ScheduleRow>& json, const std::vector<ScheduleRow>& csv,
                       Faults& faults);

}  // namespace rubicon::verify
