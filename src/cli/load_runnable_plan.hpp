#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/file_provider.hpp"

namespace rubicon::cli {

/// A plan that was read to be run, and what is to be said of it.
struct ReadPlan {
  std::unique_ptr<interpreter::PlanModel> plan;  ///< null if it cannot be run
  std::vector<interpreter::Diagnostic> found;    ///< sorted
};

/// Reads and checks a plan that is to be run, with `set` for its parameters.
ReadPlan read_runnable_plan(const std::string& plan, interpreter::FileProvider& files,
                            interpreter::SourceMap& sources,
                            const interpreter::ParameterTexts& set);

/// Reads and checks a plan that is to be run, with `set` for its parameters, and prints what is
/// wrong with it; null if it cannot be run. Paths in the plan and in `sources` are relative to the
/// folder of the plan.
/// A plan need not have anything to do `without_tasks`. `inputs` gets the files that were read.
std::unique_ptr<interpreter::PlanModel> load_runnable_plan(const std::string& path,
                                                           interpreter::SourceMap& sources,
                                                           const interpreter::ParameterTexts& set,
                                                           bool without_tasks = false,
                                                           std::set<std::string>* inputs = nullptr);

}  // namespace rubicon::cli
