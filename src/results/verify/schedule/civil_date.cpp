#include "src/results/verify/schedule/civil_date.hpp"

#include <fmt/format.h>

#include <charconv>

#include "src/results/verify/input/fault.hpp"

namespace rubicon::verify {

namespace {

/// Digits of a date; throws if they are none or the number is out of range.
int digits(std::string_view text, std::size_t begin, std::size_t count, int least, int most) {
  int value = -1;
  if (text.size() >= begin + count) {
    const std::string_view part = text.substr(begin, count);
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || end != part.data() + part.size()) value = -1;
  }
  if (value < least || value > most) {
    throw UnreadableInput(fmt::format("expected a date, found '{}'", text));
  }
  return value;
}

}  // namespace

/// Counted year by year and month by month.
std::int64_t day_number(std::string_view text) {
  const int year = digits(text, 0, 4, 1, 9999);
  const int month = digits(text, 5, 2, 1, 12);
  const int day = digits(text, 8, 2, 1, 31);
  const auto leap = [](int y) { return (y % 4 == 0 && y % 100 != 0) || y % 400 == 0; };
  std::int64_t days = 0;
  for (int y = 1970; y < year; ++y) days += leap(y) ? 366 : 365;
  for (int y = year; y < 1970; ++y) days -= leap(y) ? 366 : 365;
  constexpr int kLengths[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  for (int m = 1; m < month; ++m) days += kLengths[m - 1] + (m == 2 && leap(year) ? 1 : 0);
  return days + day - 1;
}

std::int64_t minute_number(std::string_view text) {
  const std::int64_t hour = digits(text, 11, 2, 0, 23);
  return day_number(text) * kMinutesOfDay + hour * 60 + digits(text, 14, 2, 0, 59);
}

}  // namespace rubicon::verify
