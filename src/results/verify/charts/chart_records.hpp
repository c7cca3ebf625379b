#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "src/results/verify/charts/charts_result.hpp"

namespace rubicon::verify {

/// What is wrong with the report of a step and with what its records tell: by where the chart
/// before has the robots then, by the closed lanes, and by the charts that came of it. `planned`:
/// the charts of the step before anybody yielded, by robot.
std::vector<std::string> chart_record_faults(const ChartsResult& result, std::size_t step,
                                             const std::vector<std::vector<ChartStop>>& planned);

}  // namespace rubicon::verify
