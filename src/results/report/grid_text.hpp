#pragma once

#include <string>

#include "interpreter/check/check_grid.hpp"

namespace rubicon::report {

/// What became of a network of cells: cost, bound, makespan, work; for people.
std::string grid_table(const interpreter::GridSpec& spec, const grid::GridSolution& solution);
/// The same by agent.
std::string grid_csv(const interpreter::GridSpec& spec, const grid::GridSolution& solution);
/// All of it: the map, the agents and their ways, one letter a tick (r, l, d, u: to the right, to
/// the left, down, up as the map is written; w: waits). What rubicon verify reads.
std::string grid_json(const interpreter::GridSpec& spec, const grid::GridSolution& solution);

}  // namespace rubicon::report
