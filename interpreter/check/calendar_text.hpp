#pragma once

#include <optional>
#include <string_view>

namespace rubicon::interpreter {

/// Minutes since midnight of a time written HH:MM, 00:00 to 24:00; nothing for any other text.
std::optional<int> minutes_of_day(std::string_view text);

/// Whether `text` is a day of the Gregorian calendar written YYYY-MM-DD.
bool is_date(std::string_view text);

/// Whether `text` is a date and a time of day before 24:00, written "YYYY-MM-DD HH:MM".
bool is_date_and_time(std::string_view text);

/// 0 for mon ... 6 for sun; nothing for any other text.
std::optional<int> weekday(std::string_view text);

}  // namespace rubicon::interpreter
