#pragma once

#include <string>

#include "src/results/report/charts_text.hpp"

namespace rubicon::gantt {

/// The ways of robots as they are gone, time to the right and a row for each node, as one SVG text:
/// waits, what was planned at first, conflicts that were resolved, lanes that were closed, and what
/// was reported. Of many robots the first are drawn.
std::string charts_picture(const report::ChartsResult& result);

}  // namespace rubicon::gantt
