#pragma once

#include <string>

#include "src/cli/result_files.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::cli {

/// The schedule of a result as Microsoft Project XML: that of its plan, which the trace carries,
/// with what the run made of it. Prints what a schedule has no word for. Throws WrongInput.
std::string result_mspdi(const ResultFiles& result, const taskplan::Schedule& schedule);

}  // namespace rubicon::cli
