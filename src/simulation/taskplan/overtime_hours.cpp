#include "src/simulation/taskplan/overtime_hours.hpp"

#include <variant>

#include "src/simulation/taskplan/plan_calendars.hpp"

namespace rubicon::taskplan {

OvertimeHours::OvertimeHours(const interpreter::PlanModel& plan, const interpreter::Draws& draws) {
  const std::vector<schedule::WorkCalendar> calendars = calendars_of(plan, draws);
  const auto named = [&](const std::string& name) {
    const int index = calendar_index(plan, name);
    return index < 0 ? schedule::WorkCalendar() : calendars[static_cast<std::size_t>(index)];
  };
  const auto add = [&](const std::string& own, const interpreter::Charges& charges) {
    Hours& hours = hours_.emplace_back();
    if (charges.overtime == 1) return;
    hours.counts = true;
    hours.own = named(own);
    hours.normal = charges.normal.empty() ? hours.own : named(charges.normal);
    auto both = intersection(hours.own, hours.normal);
    hours.has_both = std::holds_alternative<schedule::WorkCalendar>(both);
    if (hours.has_both) hours.both = std::get<schedule::WorkCalendar>(std::move(both));
  };
  for (const interpreter::RobotSpec& robot : plan.robots) add(robot.calendar, robot.charges);
  for (const interpreter::CrewSpec& crew : plan.crews) add(crew.calendar, crew.charges);
}

Ticks OvertimeHours::in_shifts(int resource, Ticks from, Ticks to) const {
  const Hours& hours = hours_[static_cast<std::size_t>(resource)];
  if (!hours.counts) return 0;
  return hours.own.work_between(from, to) - both_between(hours, from, to);
}

Ticks OvertimeHours::out_of_shift(int resource, Ticks from, Ticks to) const {
  const Hours& hours = hours_[static_cast<std::size_t>(resource)];
  if (!hours.counts) return 0;
  return to - from - hours.own.work_between(from, to) - hours.normal.work_between(from, to) +
         both_between(hours, from, to);
}

}  // namespace rubicon::taskplan
