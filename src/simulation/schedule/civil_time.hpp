#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "src/simulation/schedule/ticks.hpp"

namespace rubicon::schedule {

/// A day of the proleptic Gregorian calendar.
struct Date {
  int year = 1970;
  int month = 1;  ///< 1 January ... 12 December
  int day = 1;    ///< 1 ... 31

  bool operator==(const Date&) const = default;
};

/// A date and a time of day, to the minute. There are no time zones and no summer time: a day has
/// 24 hours.
struct CivilTime {
  Date date;
  int minute_of_day = 0;  ///< 0 ... 1439

  bool operator==(const CivilTime&) const = default;
};

/// When a plan begins that does not say when: a Monday.
inline constexpr CivilTime kUndatedStart{{2024, 1, 1}, 0};

/// Whether the month has this day.
bool is_valid(const Date& date);

/// Days from 1970-01-01 to the date, which must be valid. Source: H. Hinnant, "chrono-Compatible
/// Low-Level Date Algorithms", days_from_civil.
std::int64_t days_from_date(const Date& date);

/// The date so many days after 1970-01-01. Source: as above, civil_from_days.
Date date_from_days(std::int64_t days);

/// 0 Monday ... 6 Sunday, of the day so many days after 1970-01-01 (a Thursday).
int weekday_from_days(std::int64_t days);
int weekday_of(const Date& date);

/// Reads "YYYY-MM-DD", years 0001 to 9999; nothing for any other text or a day that is not there.
std::optional<Date> parse_date(std::string_view text);

/// Reads "HH:MM", 00:00 to 24:00, as minutes since midnight; nothing for any other text.
std::optional<int> parse_minute_of_day(std::string_view text);

/// Reads "YYYY-MM-DD HH:MM", 00:00 to 23:59; nothing for any other text.
std::optional<CivilTime> parse_civil_time(std::string_view text);

/// "YYYY-MM-DD".
std::string text_of(const Date& date);

/// "YYYY-MM-DD HH:MM".
std::string text_of(const CivilTime& time);

/// The moment `ticks` after `start`, rounded down to its minute.
CivilTime civil_time_at(const CivilTime& start, Ticks ticks);

/// The ticks from `start` to `time`; nothing if they are more than kEndOfTime either way.
std::optional<Ticks> ticks_between(const CivilTime& start, const CivilTime& time);

}  // namespace rubicon::schedule
