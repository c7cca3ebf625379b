#pragma once

#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/building_io/building_plan.hpp"
#include "src/exchange/building_io/match_file.hpp"

namespace rubicon::building_io {

/// Mistakes of a plan that was made with a match file, at the places where the match file says what
/// is wrong, each once, however many elements it is about. What comes from elsewhere (the schedule,
/// the model) has no place; what stands in other files stays. `file` is the plan among the sources,
/// which hold the match file too.
std::vector<interpreter::Diagnostic> at_match_places(
    const std::vector<interpreter::Diagnostic>& mistakes, const MatchFile& match,
    const BuildingPlan& plan, interpreter::FileId file, const interpreter::SourceMap& sources);

}  // namespace rubicon::building_io
