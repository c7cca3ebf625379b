#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "src/simulation/schedule/civil_time.hpp"
#include "src/simulation/schedule/lost_days.hpp"
#include "src/simulation/schedule/work_calendar.hpp"

namespace rubicon::schedule {

/// A calendar as a plan writes it.
struct CalendarRules {
  /// The shifts of some days of the week. Several entries for a day add up.
  struct Shift {
    int first_day = 0;  ///< 0 Monday ... 6 Sunday
    int last_day = 0;
    std::vector<std::pair<int, int>> minutes;  ///< from, to: minutes of the day, 0 ... 1440
  };
  std::string name;
  std::vector<Shift> shifts;
  std::vector<Date> off;  ///< no shift that day; a night shift ends and begins anew at midnight
  bool carry_over = false;
  LostShares lost = {};
  std::optional<Weather> weather = {};  ///< nothing: no day is lost

  bool loses_days() const {
    return std::any_of(lost.begin(), lost.end(), [](double share) { return share > 0; });
  }
};

/// The calendar for a plan that starts at `start`, or what is wrong with the rules.
std::variant<WorkCalendar, CalendarMistake> calendar_of(const CalendarRules& rules,
                                                        const CivilTime& start);

}  // namespace rubicon::schedule
