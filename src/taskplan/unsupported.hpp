#pragma once

#include <vector>

#include "interpreter/diagnostic.hpp"
#include "interpreter/plan_model.hpp"

namespace rubicon::taskplan {

/// What the plan asks for that a run does not execute: an error X01 at each place, so that nothing
/// is ignored silently. The size of a crew, which only cost would use, is a warning X02.
std::vector<interpreter::Diagnostic> unsupported(const interpreter::PlanModel& plan);

}  // namespace rubicon::taskplan
