#pragma once

#include <string>

#include "src/results/gantt/chart.hpp"

namespace rubicon::gantt {

/// The chart as one SVG text: no scripts, no fonts and no files of others. The full names and times
/// of bars are titles that viewers show under the pointer.
std::string svg_chart(const Chart& chart);

}  // namespace rubicon::gantt
