#include "src/exchange/project_io/dates.hpp"

#include "src/simulation/schedule/civil_time.hpp"

namespace rubicon::project_io {

namespace {

constexpr long long kMinutesPerDay = 1'440;

}  // namespace

std::optional<int> day_number(std::string_view date) {
  const auto day = schedule::parse_date(date);
  if (!day) return std::nullopt;
  return static_cast<int>(schedule::days_from_date(*day));
}

std::string date_text(int day) { return schedule::text_of(schedule::date_from_days(day)); }

std::optional<long long> minute_number(std::string_view moment) {
  const auto time = schedule::parse_civil_time(moment.substr(0, 16));
  if (!time) return std::nullopt;
  return schedule::days_from_date(time->date) * kMinutesPerDay + time->minute_of_day;
}

std::optional<long long> second_number(std::string_view moment) {
  const auto minutes = minute_number(moment);
  if (!minutes) return std::nullopt;
  const bool has_seconds = moment.size() == 19 && moment[16] == ':';
  return *minutes * 60 + (has_seconds ? (moment[17] - '0') * 10 + (moment[18] - '0') : 0);
}

std::string moment_text(long long minute) {
  const std::int64_t day = schedule::floor_division(minute, kMinutesPerDay);
  return schedule::text_of(schedule::CivilTime{schedule::date_from_days(day),
                                               static_cast<int>(minute - day * kMinutesPerDay)});
}

}  // namespace rubicon::project_io
