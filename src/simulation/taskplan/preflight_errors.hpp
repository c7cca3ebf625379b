#pragma once

#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/diagnostic.hpp"

namespace rubicon::taskplan {

/// Why a checked plan cannot be run: what a run does not execute (X01, so that nothing is ignored
/// silently), days off without a date to count from (X02), calendars without working time, or
/// without common hours of all that a task needs (X03). At their places.
std::vector<interpreter::Diagnostic> preflight_errors(const interpreter::PlanModel& plan);

}  // namespace rubicon::taskplan
