#include "tests/unit/schedule/calendar_cases.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rubicon::test {

using schedule::CalendarMistake;
using schedule::CalendarRules;
using schedule::CivilTime;
using schedule::Ticks;
using schedule::WorkCalendar;

Ticks moment(std::string_view start, std::string_view text) {
  return schedule::ticks_between(schedule::parse_civil_time(start).value(),
                                 schedule::parse_civil_time(text).value())
      .value();
}

std::string moment_text(std::string_view start, Ticks time) {
  const CivilTime from = schedule::parse_civil_time(start).value();
  const Ticks rest = time - schedule::floor_division(time, schedule::kMinute) * schedule::kMinute;
  std::string text = schedule::text_of(schedule::civil_time_at(from, time));
  if (rest != 0) text += fmt::format(" + {} ns", rest);
  return text;
}

CalendarRules daily_shift() {
  CalendarRules rules;
  rules.name = "daily";
  rules.shifts = {{0, 6, {{7 * 60, 12 * 60}, {13 * 60, 16 * 60}}}};
  return rules;
}

CalendarRules weekday_shift() {
  CalendarRules rules = daily_shift();
  rules.name = "weekdays";
  rules.shifts[0].last_day = 4;
  rules.off = {{2026, 3, 9}};
  return rules;
}

WorkCalendar calendar(const CalendarRules& rules, std::string_view start) {
  auto made = schedule::calendar_of(rules, schedule::parse_civil_time(start).value());
  if (const auto* mistake = std::get_if<CalendarMistake>(&made)) {
    ADD_FAILURE() << mistake->message;
    return {};
  }
  return std::get<WorkCalendar>(std::move(made));
}

}  // namespace rubicon::test
