#pragma once

#include <string>
#include <vector>

#include "src/results/gantt/chart.hpp"

namespace rubicon::gantt {

/// The rows of a chart below its lanes, in the order in which they begin: one for each bar if there
/// are not too many, else one for each place (what stands before the last point of the name) with
/// several tasks; none if these are too many as well. `title` gets what they are.
std::vector<Lane> chart_rows(const std::vector<Bar>& tasks, std::string& title);

}  // namespace rubicon::gantt
