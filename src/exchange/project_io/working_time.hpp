#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "src/exchange/project_io/fixed_dates.hpp"
#include "src/exchange/project_io/plan_calendar.hpp"

namespace rubicon::project_io {

/// The work (seconds) that begins and ends just at these dates if it is done when all of these
/// calendars work, in a plan that starts at `start`; none: day and night. Nothing if no work does.
std::optional<std::int64_t> work_between(const FixedDates& dates,
                                         const std::vector<PlanCalendar>& calendars,
                                         const Moment& start);

}  // namespace rubicon::project_io
