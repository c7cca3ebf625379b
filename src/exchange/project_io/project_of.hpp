#pragma once

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/project_io/project.hpp"
#include "src/exchange/project_io/simulated_run.hpp"

namespace rubicon::project_io {

/// The schedule that a checked plan stands for: tasks with their durations and links, crews and
/// robots as resources, calendars. What the plan says holds; where its import block (see
/// carried.hpp) carries more about the same thing and does not contradict, that is taken too, so
/// that the project that `plan_text` wrote comes back equal. Listed as warnings: what a schedule
/// has no word for (I09: motions, zones, ...), and statements of the block that are not understood
/// (I10). With `run` (not null) the schedule is that of the run: see `take_run`; motions then are
/// in its times and not listed.
Project project_of(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                   interpreter::Diagnostics& diagnostics, const SimulatedRun* run = nullptr);

}  // namespace rubicon::project_io
