#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

/// A calendar as a plan has it: a week and days off.
struct PlanCalendar {
  std::array<DayTimes, 7> week;
  std::vector<std::string> off;  ///< YYYY-MM-DD, in order
  int special_days = 0;          ///< days with hours of their own, which a plan cannot say
  bool cut = false;              ///< days off were too many
  bool operator==(const PlanCalendar&) const = default;
};

/// The calendar with all that it takes from its base calendars. Days before `from` (YYYY-MM-DD;
/// empty: none) are left out: they never matter to what starts then. Nothing if no day of the week
/// has work.
std::optional<PlanCalendar> plan_calendar(const Project& project, const Calendar& calendar,
                                          const std::string& from);

/// The same of a calendar that was read from a plan.
PlanCalendar plan_calendar(const interpreter::CalendarSpec& spec);

}  // namespace rubicon::project_io
