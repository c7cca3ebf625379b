#pragma once

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "src/simulation/taskplan/schedule.hpp"
#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::taskplan {

/// The one motion of a short plan. Done when it is at its goal, or as near as `within` allows;
/// short when its script ended elsewhere. `sink` may be null.
Schedule run_short(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                   trace::TraceSink* sink, const RunOptions& options);

}  // namespace rubicon::taskplan
