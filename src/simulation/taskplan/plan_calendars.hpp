#pragma once

#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/schedule/civil_time.hpp"
#include "src/simulation/schedule/work_calendar.hpp"

namespace rubicon::taskplan {

/// When a plan begins: its `start_at`, else `schedule::kUndatedStart`.
schedule::CivilTime start_of(const interpreter::PlanModel& plan);

/// The plan's calendars, as in the file, with the weather that was drawn. They must be without
/// mistakes.
std::vector<schedule::WorkCalendar> calendars_of(const interpreter::PlanModel& plan,
                                                 const interpreter::Draws& draws = {});

/// The calendar of that name, -1 for none.
int calendar_index(const interpreter::PlanModel& plan, const std::string& name);

/// What a task holds from start to finish: its robot and the crews of `by`; a task without a robot
/// also the crews that do its works. Robots are numbered first, then crews.
std::vector<int> held_resources(const interpreter::PlanModel& plan,
                                const interpreter::TaskSpec& task);

/// How many people of a crew a task takes when it takes any; of a robot, 1.
int people_of(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task, int resource);

/// The robot or crew that the member of a pool is.
int resource_of(const interpreter::PlanModel& plan, const interpreter::PoolMember& member);

}  // namespace rubicon::taskplan
