#pragma once

#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/schedule/work_calendar.hpp"

namespace rubicon::taskplan {

using schedule::Ticks;

/// Which hours of a robot or crew are overtime: those outside of the calendar that its `overtime`
/// names, or of its own. Who has no `overtime` has none.
class OvertimeHours {
 public:
  OvertimeHours() = default;
  OvertimeHours(const interpreter::PlanModel& plan, const interpreter::Draws& draws);

  /// Overtime in the shifts of its own calendar.
  Ticks in_shifts(int resource, Ticks from, Ticks to) const;
  /// Overtime out of these.
  Ticks out_of_shift(int resource, Ticks from, Ticks to) const;

 private:
  struct Hours {
    bool counts = false;
    schedule::WorkCalendar own, normal;
    bool has_both = true;         ///< whether these have common hours
    schedule::WorkCalendar both;  ///< the common hours
  };
  static Ticks both_between(const Hours& hours, Ticks from, Ticks to) {
    return hours.has_both ? hours.both.work_between(from, to) : 0;
  }

  std::vector<Hours> hours_;  ///< to each robot, then each crew
};

}  // namespace rubicon::taskplan
