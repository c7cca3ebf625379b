#pragma once

#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/exchange/project_io/listing.hpp"

namespace rubicon::project_io {

/// The crew work of a task, in seconds: the mean of what is not certain.
double crew_seconds(const interpreter::TaskSpec& task);

/// Lists what of a plan a schedule has no word for: one warning (I09) for each kind, with the
/// names. `tasks` are those that the schedule has lines for; those that are null are passed over.
/// The schedule of a run has the dates of the run: what made them is not listed then.
void list_left_out(const interpreter::PlanModel& plan,
                   const std::vector<const interpreter::TaskSpec*>& tasks, bool of_run,
                   Listing& listing);

}  // namespace rubicon::project_io
