#pragma once

#include <string>

#include "interpreter/check/check_grid.hpp"

namespace rubicon::report {

/// What became of jobs on a network of cells: jobs per hour, ticks, waits, work; for people.
std::string jobs_table(const interpreter::GridSpec& spec, const grid::JobsResult& result);
/// The same by job, and by agent.
std::string jobs_csv(const interpreter::GridSpec& spec, const grid::JobsResult& result);
std::string job_agents_csv(const interpreter::GridSpec& spec, const grid::JobsResult& result);
/// All of it: the map, the jobs, the agents and their ways, one letter a tick (r, l, d, u: to the
/// right, to the left, down, up as the map is written; w: stays), the moves that ended late. What
/// rubicon verify reads.
std::string jobs_json(const interpreter::GridSpec& spec, const grid::JobsResult& result);

}  // namespace rubicon::report
