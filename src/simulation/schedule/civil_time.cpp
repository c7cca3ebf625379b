#include "src/simulation/schedule/civil_time.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>

namespace rubicon::schedule {

namespace {

constexpr int kMinutesPerDay = 24 * 60;

/// A cycle of the Gregorian calendar: 400 years, and the days from 0000-03-01 to 1970-01-01.
constexpr std::int64_t kDaysPerEra = 146097;
constexpr std::int64_t kDaysToEpoch = 719468;

/// The number that the digits of `text` write; nothing if one of them is no digit.
std::optional<int> digits(std::string_view text) {
  int value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    value = value * 10 + (c - '0');
  }
  return value;
}

bool is_leap(int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }

}  // namespace

bool is_valid(const Date& date) {
  constexpr std::array<int, 12> kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (date.month < 1 || date.month > 12 || date.day < 1) return false;
  const int leap_day = date.month == 2 && is_leap(date.year) ? 1 : 0;
  return date.day <= kDays[static_cast<std::size_t>(date.month - 1)] + leap_day;
}

// Years begin in March here, so that the leap day is the last day of its year.
std::int64_t days_from_date(const Date& date) {
  const std::int64_t year = std::int64_t{date.year} - (date.month <= 2 ? 1 : 0);
  const std::int64_t era = floor_division(year, 400);
  const std::int64_t year_of_era = year - era * 400;
  const std::int64_t month = (date.month + 9) % 12;
  const std::int64_t day_of_year = (153 * month + 2) / 5 + date.day - 1;
  const std::int64_t day_of_era =
      year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year;
  return era * kDaysPerEra + day_of_era - kDaysToEpoch;
}

Date date_from_days(std::int64_t days) {
  const std::int64_t shifted = days + kDaysToEpoch;
  const std::int64_t era = floor_division(shifted, kDaysPerEra);
  const std::int64_t day_of_era = shifted - era * kDaysPerEra;
  const std::int64_t year_of_era =
      (day_of_era - day_of_era / 1460 + day_of_era / 36524 - day_of_era / 146096) / 365;
  const std::int64_t day_of_year =
      day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
  const std::int64_t month = (5 * day_of_year + 2) / 153;
  Date date;
  date.day = static_cast<int>(day_of_year - (153 * month + 2) / 5 + 1);
  date.month = static_cast<int>(month < 10 ? month + 3 : month - 9);
  date.year = static_cast<int>(year_of_era + era * 400) + (date.month <= 2 ? 1 : 0);
  return date;
}

int weekday_from_days(std::int64_t days) {
  constexpr std::int64_t kEpochWeekday = 3;  // a Thursday
  const std::int64_t shifted = days + kEpochWeekday;
  return static_cast<int>(shifted - floor_division(shifted, 7) * 7);
}

int weekday_of(const Date& date) { return weekday_from_days(days_from_date(date)); }

std::optional<Date> parse_date(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
  const auto year = digits(text.substr(0, 4));
  const auto month = digits(text.substr(5, 2));
  const auto day = digits(text.substr(8, 2));
  if (!year || !month || !day || *year < 1) return std::nullopt;
  const Date date{*year, *month, *day};
  if (!is_valid(date)) return std::nullopt;
  return date;
}

std::optional<int> parse_minute_of_day(std::string_view text) {
  if (text.size() != 5 || text[2] != ':') return std::nullopt;
  const auto hours = digits(text.substr(0, 2)), minutes = digits(text.substr(3, 2));
  if (!hours || !minutes || *minutes > 59) return std::nullopt;
  const int total = *hours * 60 + *minutes;
  if (total > kMinutesPerDay) return std::nullopt;
  return total;
}

std::optional<CivilTime> parse_civil_time(std::string_view text) {
  if (text.size() != 16 || text[10] != ' ') return std::nullopt;
  const auto date = parse_date(text.substr(0, 10));
  const auto minutes = parse_minute_of_day(text.substr(11));
  if (!date || !minutes || *minutes == kMinutesPerDay) return std::nullopt;
  return CivilTime{*date, *minutes};
}

std::string text_of(const Date& date) {
  return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
}

std::string text_of(const CivilTime& time) {
  return fmt::format("{} {:02}:{:02}", text_of(time.date), time.minute_of_day / 60,
                     time.minute_of_day % 60);
}

CivilTime civil_time_at(const CivilTime& start, Ticks ticks) {
  const std::int64_t minutes = floor_division(ticks, kMinute) + start.minute_of_day;
  const std::int64_t days = floor_division(minutes, kMinutesPerDay);
  return {date_from_days(days_from_date(start.date) + days),
          static_cast<int>(minutes - days * kMinutesPerDay)};
}

std::optional<Ticks> ticks_between(const CivilTime& start, const CivilTime& time) {
  const std::int64_t minutes =
      (days_from_date(time.date) - days_from_date(start.date)) * kMinutesPerDay +
      time.minute_of_day - start.minute_of_day;
  constexpr std::int64_t kMost = kEndOfTime / kMinute;
  if (minutes < -kMost || minutes > kMost) return std::nullopt;
  return minutes * kMinute;
}

}  // namespace rubicon::schedule
