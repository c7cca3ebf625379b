#pragma once

#include <memory>
#include <string>

#include "interpreter/check/plan_model.hpp"

namespace rubicon::cli {

/// Reads and checks a plan that is to be run, with `set` for its parameters, and prints what is
/// wrong with it; null if it cannot be run. Paths in the plan and in `sources` are relative to the
/// folder of the plan.
std::unique_ptr<interpreter::PlanModel> load_runnable_plan(const std::string& path,
                                                           interpreter::SourceMap& sources,
                                                           const interpreter::ParameterTexts& set);

}  // namespace rubicon::cli
