#pragma once

#include <string>
#include <string_view>

#include "src/simulation/schedule/calendar_rules.hpp"
#include "src/simulation/schedule/civil_time.hpp"
#include "src/simulation/schedule/work_calendar.hpp"

namespace rubicon::test {

/// The moment written "YYYY-MM-DD HH:MM" for a plan that starts at `start`; both must be such
/// texts.
schedule::Ticks moment(std::string_view start, std::string_view text);

/// The other way round; for a time that is no whole minute the rest follows in nanoseconds.
std::string moment_text(std::string_view start, schedule::Ticks time);

/// Every day 07:00-12:00 and 13:00-16:00: 8 h a day.
schedule::CalendarRules daily_shift();

/// Monday to Friday as above, and 2026-03-09, a Monday, off.
schedule::CalendarRules weekday_shift();

/// The calendar of rules that are right; a test that calls this with others fails.
schedule::WorkCalendar calendar(const schedule::CalendarRules& rules, std::string_view start);

}  // namespace rubicon::test
