#pragma once

#include "interpreter/syntax/syntax.hpp"

namespace rubicon::interpreter::plan_check {

/// Whether a network has cells and agents, and no lanes: policy grid.
bool is_of_cells(const syntax::NetworkItem& item);

}  // namespace rubicon::interpreter::plan_check
