#pragma once

#include <nlohmann/json.hpp>

#include "interpreter/check/check_grid.hpp"

namespace rubicon::report {

/// The map of a network of cells in a result: its file, and its rows as the map is written.
nlohmann::ordered_json grid_map_json(const interpreter::GridSpec& spec);

}  // namespace rubicon::report
