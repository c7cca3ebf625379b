#pragma once

#include <cstdint>
#include <string_view>

namespace rubicon::verify {

inline constexpr std::int64_t kMinutesOfDay = 1'440;

/// Days since 1970-01-01 of YYYY-MM-DD, whatever follows. Throws UnreadableInput for what is no
/// date.
std::int64_t day_number(std::string_view text);

/// Minutes since 1970-01-01 00:00 of "YYYY-MM-DD HH:MM". Throws UnreadableInput.
std::int64_t minute_number(std::string_view text);

}  // namespace rubicon::verify
