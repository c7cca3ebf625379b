#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

/// Days of the Gregorian calendar as numbers: 0 is 1970-01-01.
namespace rubicon::project_io {

/// The days of the week as plans name them.
inline constexpr std::array<const char*, 7> kDays = {"mon", "tue", "wed", "thu",
                                                     "fri", "sat", "sun"};

/// Seconds from the beginning of a plan beyond which no date is taken over; dates of plans go a
/// little farther.
inline constexpr long long kFarthestDate = 100LL * 365 * 86'400;

/// The number of a day written YYYY-MM-DD; nothing for any other text.
std::optional<int> day_number(std::string_view date);

/// The day with this number, YYYY-MM-DD, in the years 1 to 9999.
std::string date_text(int day);

/// Minutes from 1970-01-01 00:00 to a moment "YYYY-MM-DD HH:MM[:SS]", seconds left off; nothing for
/// any other text.
std::optional<long long> minute_number(std::string_view moment);

/// The same in seconds.
std::optional<long long> second_number(std::string_view moment);

/// The moment "YYYY-MM-DD HH:MM" with this number.
std::string moment_text(long long minute);

}  // namespace rubicon::project_io
