#pragma once

#include <string>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/source.hpp"

namespace rubicon::comparison {

/// The values of a robot's parameters over time on the first way that a guide finds for the task,
/// as SVG, one strip for each parameter that moves: as they are driven, all of a leg arriving
/// together, and as each would be by itself, at its full speed until it is there (Langari 2015,
/// Figures 4.6 to 4.9). "" if the task makes no motion. Throws std::invalid_argument with a message
/// for the user.
std::string way_chart(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                      const std::string& task, const std::string& kind);

}  // namespace rubicon::comparison
