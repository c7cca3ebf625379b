#pragma once

#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/grid.hpp"

namespace rubicon::interpreter {

/// The networks of a plan that have a policy with numbers, a map, a scenario or agents, in file
/// order. Says nothing of mistakes: parse_plan does.
std::vector<syntax::GridItem> parse_grids(const SourceMap& sources, FileId file);

}  // namespace rubicon::interpreter
