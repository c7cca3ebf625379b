#pragma once

#include <string>

#include "src/fleets/layout/best_layouts.hpp"

namespace rubicon::report {

/// A row for each layout that no other beats; `chosen` counts from 1. For people.
std::string layout_table(const std::string& plan, const layout::BestLayouts& found, int chosen);
/// The same with plain numbers.
std::string layout_csv(const layout::BestLayouts& found);
/// The same, and the modules, nodes and lanes of each.
std::string layout_json(const std::string& plan, const layout::BestLayouts& found);

}  // namespace rubicon::report
