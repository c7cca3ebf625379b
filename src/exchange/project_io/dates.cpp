#include "src/exchange/project_io/dates.hpp"

#include <fmt/format.h>

#include <chrono>

#include "interpreter/check/calendar_text.hpp"

namespace rubicon::project_io {

namespace {

constexpr long long kMinutesPerDay = 24 * 60;

int number(std::string_view digits) {
  int value = 0;
  for (const char c : digits) value = value * 10 + (c - '0');
  return value;
}

}  // namespace

std::optional<int> day_number(std::string_view date) {
  if (!interpreter::is_date(date)) return std::nullopt;
  const std::chrono::year_month_day day{
      std::chrono::year(number(date.substr(0, 4))),
      std::chrono::month(static_cast<unsigned>(number(date.substr(5, 2)))),
      std::chrono::day(static_cast<unsigned>(number(date.substr(8, 2))))};
  return static_cast<int>(std::chrono::sys_days(day).time_since_epoch().count());
}

std::string date_text(int day) {
  const std::chrono::year_month_day date{std::chrono::sys_days(std::chrono::days(day))};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

std::optional<long long> minute_number(std::string_view moment) {
  if (!interpreter::is_date_and_time(moment.substr(0, 16))) return std::nullopt;
  return *day_number(moment.substr(0, 10)) * kMinutesPerDay +
         *interpreter::minutes_of_day(moment.substr(11, 5));
}

std::string moment_text(long long minute) {
  const long long day = (minute >= 0 ? minute : minute - (kMinutesPerDay - 1)) / kMinutesPerDay;
  const long long of_day = minute - day * kMinutesPerDay;
  return fmt::format("{} {:02}:{:02}", date_text(static_cast<int>(day)), of_day / 60, of_day % 60);
}

}  // namespace rubicon::project_io
