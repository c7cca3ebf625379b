#pragma once

#include <array>
#include <string>

#include "src/simulation/schedule/ticks.hpp"

namespace rubicon::schedule {

/// By weekday_of: 0 Monday ... 6 Sunday.
inline constexpr std::array<const char*, 7> kWeekdayNames = {"Mon", "Tue", "Wed", "Thu",
                                                             "Fri", "Sat", "Sun"};

/// h:mm:ss, rounded to seconds; for times from 0 on.
std::string clock_text(Ticks ticks);

/// "47 h", "1 h 30 min", "7 h 33 min 14.1 s"; from 0 on.
std::string duration_text(Ticks ticks);

}  // namespace rubicon::schedule
