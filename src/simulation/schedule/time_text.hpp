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

}  // namespace rubicon::schedule
