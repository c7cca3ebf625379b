#pragma once

#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"

namespace rubicon::test {

/// A plan with everything that a header can tell of.
interpreter::PlanModel rich_plan();

/// What the writer makes of it: its header.
std::string written_header(const interpreter::PlanModel& plan);

/// What the writer makes of one record of each kind, with all members, and of some with fewer.
std::vector<std::string> written_records();

}  // namespace rubicon::test
