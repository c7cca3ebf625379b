#pragma once

#include <vector>

#include "src/results/verify/input/scene.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"

namespace rubicon::verify {

/// The dates of rows: where the plan has a `start_at`, the minutes in which each task begins and
/// ends by its own times; else none.
void check_dates(const Scene& scene, const std::vector<ScheduleRow>& rows, ResultFile file,
                 Faults& faults);

/// The begin and the end of the whole, and the currency of its cost.
void check_whole(const Scene& scene, const ScheduleJson& schedule, Faults& faults);

}  // namespace rubicon::verify
