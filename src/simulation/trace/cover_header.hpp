#pragma once

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::trace {

/// `cover` of a task in the header (docs/trace.md): what it lays or drills, where its tool works,
/// the floor, and the steps by which its way was found.
void write_cover(JsonBuilder& json, const interpreter::PlanModel& plan,
                 const interpreter::TaskSpec& task);

}  // namespace rubicon::trace
