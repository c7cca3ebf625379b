#pragma once

#include <string>

#include "interpreter/check/plan_model.hpp"

namespace rubicon::comparison {

/// What the way over an area does of a task that covers one (`cover` is set), as a table of two
/// columns, a table of CSV, or JSON: what it covers, its length beside the bound, turns, metres
/// inside holes and outside, cells, lines.
std::string cover_way_text(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task);
std::string cover_way_csv(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task);
std::string cover_way_json(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task);

/// The steps by which that way was found, a picture for each, as SVG.
std::string cover_steps_svg(const interpreter::PlanModel& plan, const interpreter::TaskSpec& task);

}  // namespace rubicon::comparison
