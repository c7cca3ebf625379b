#pragma once

#include <string>
#include <vector>

#include "interpreter/syntax/source.hpp"
#include "src/fleets/charts/reports.hpp"
#include "src/fleets/charts/stopping.hpp"

namespace rubicon::interpreter {

/// A checked network with policy charts: robots with their errands, and what they report.
struct ChartsSpec {
  int network = 0;  ///< index into networks
  std::vector<charts::Robot> robots;
  charts::PlanSettings settings;
  std::vector<charts::SiteReport> reports;  ///< by time
  std::vector<Span> report_spans;           ///< of each
  std::vector<charts::Barrier> barriers;
  charts::Stopping stopping;
};

}  // namespace rubicon::interpreter
