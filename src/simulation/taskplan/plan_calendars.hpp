#pragma once

#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/schedule/calendar_rules.hpp"
#include "src/simulation/schedule/civil_time.hpp"
#include "src/simulation/schedule/work_calendar.hpp"

namespace rubicon::taskplan {

/// When a plan begins: its `start_at`, else Monday, 2024-01-01 00:00.
schedule::CivilTime start_of(const interpreter::PlanModel& plan);

/// A calendar of a plan as the schedule module takes it.
schedule::CalendarRules rules_of(const interpreter::CalendarSpec& spec);

/// The plan's calendars, as in the file. They must be without mistakes.
std::vector<schedule::WorkCalendar> calendars_of(const interpreter::PlanModel& plan);

/// The calendar of that name, -1 for none.
int calendar_index(const interpreter::PlanModel& plan, const std::string& name);

/// What a task holds from start to finish: its robot and the crews of `by`; a task without a robot
/// also the crews that do its works. Robots are numbered first, then crews.
std::vector<int> held_resources(const interpreter::PlanModel& plan,
                                const interpreter::TaskSpec& task);

}  // namespace rubicon::taskplan
