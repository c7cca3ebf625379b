#include "src/simulation/schedule/calendar_rules.hpp"

#include <fmt/format.h>

namespace rubicon::schedule {

std::variant<WorkCalendar, CalendarMistake> calendar_of(const CalendarRules& rules,
                                                        const CivilTime& start) {
  WorkCalendar::Parts parts;
  parts.names = {rules.name};
  parts.carry_over = rules.carry_over;
  const std::int64_t first_day = days_from_date(start.date);
  const std::int64_t monday = first_day - weekday_from_days(first_day);
  parts.monday = -(first_day - monday) * kDay - start.minute_of_day * kMinute;
  parts.first_day = monday;
  if (rules.weather && rules.loses_days()) parts.lost = {rules.lost, *rules.weather};
  for (const CalendarRules::Shift& shift : rules.shifts) {
    if (shift.first_day < 0 || shift.last_day > 6 || shift.first_day > shift.last_day) {
      return CalendarMistake{fmt::format(
          "calendar '{}' has shifts from day {} to day {}; expected days from 0 (Monday) to 6 "
          "(Sunday), in this order",
          rules.name, shift.first_day, shift.last_day)};
    }
    for (const auto& [from, to] : shift.minutes) {
      if (from < 0 || from >= to || to > kDay / kMinute) {
        return CalendarMistake{fmt::format(
            "calendar '{}' has a shift from minute {} to minute {} of a day; expected 0 to 1440, "
            "the end after the begin",
            rules.name, from, to)};
      }
      for (int day = shift.first_day; day <= shift.last_day; ++day) {
        parts.week.push_back({day * kDay + from * kMinute, day * kDay + to * kMinute});
      }
    }
  }
  for (const Date& date : rules.off) {
    if (!is_valid(date)) {
      return CalendarMistake{fmt::format("calendar '{}' has a day off, {}, that is no date",
                                         rules.name, text_of(date))};
    }
    parts.off_days.push_back(days_from_date(date) - monday);
  }
  return WorkCalendar::make(std::move(parts));
}

}  // namespace rubicon::schedule
