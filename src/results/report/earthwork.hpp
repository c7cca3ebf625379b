#pragma once

#include <string>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/taskplan/schedule.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::report {

/// What was dug, how fast and at which cost, and the queues of the trucks; "" where nobody dug.
std::string earthwork_table(const taskplan::Schedule& schedule);

/// How often the tasks of machines with dynamic workspaces waited for others, planned round what
/// these were foreseen to sweep, or made workspaces overlap; "" where there are none.
std::string workspaces_table(const taskplan::Schedule& schedule);
/// The same of one task, as member "workspaces" of its object.
void write_workspaces(trace::JsonBuilder& json, const taskplan::Schedule& schedule,
                      const taskplan::TaskOutcome& task);

/// The same of one task that digs, as member "dig" of its object.
void write_dig(trace::JsonBuilder& json, const taskplan::Schedule& schedule,
               const taskplan::TaskOutcome& task);

/// The same of one whose robot digs, as member "motion_dig".
void write_motion_dig(trace::JsonBuilder& json, const taskplan::Schedule& schedule,
                      const taskplan::TaskOutcome& task);

/// What the truck of a task hauled, as member "haul".
void write_haul(trace::JsonBuilder& json, const taskplan::TaskOutcome& task);

/// What all trucks of a plan hauled, and what a cubic metre cost with those who dug it; "" where no
/// robot hauled.
std::string hauling_json(const taskplan::Schedule& schedule);

/// loads.csv: each load of each task that is done, from the arrival of its truck in the queue to
/// where it was tipped (s of working time since the task began, m3 of bank volume); "" where nobody
/// dug.
std::string loads_csv(const interpreter::PlanModel& plan, const taskplan::Schedule& schedule);

}  // namespace rubicon::report
