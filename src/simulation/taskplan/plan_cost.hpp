#pragma once

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::taskplan {

/// Whether the plan says what anything costs.
bool is_costed(const interpreter::PlanModel& plan);

/// Whether the plan says what anything burns.
bool burns_fuel(const interpreter::PlanModel& plan);

/// Adds up what robots and crews burn (l), and what tasks, robots, crews and the whole cost, in
/// exact integers: each item (a hold at a rate, days at a rental, the material of a component) to
/// the millionth of the currency. The total is rounded to the cent, and kinds, tasks and resources
/// by the largest remainder (Hamilton), so that each list adds up to the cent. `schedule` has all
/// else, its tasks with their holds.
void add_costs(const interpreter::PlanModel& plan, Schedule& schedule);

}  // namespace rubicon::taskplan
