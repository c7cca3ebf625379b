#pragma once

#include <cstdint>
#include <vector>

#include "src/fleets/grid/grid_problem.hpp"

namespace rubicon::grid {

/// How much work is done when nothing else is said: about two seconds.
inline constexpr std::int64_t kUsualExpansions = 10'000'000;
/// The first solution takes no more: each keeps 8 bytes for as long as it is sought.
inline constexpr std::int64_t kMostFirstExpansions = 100'000'000;

struct GridQuery {
  /// Cells (of one agent, at one time) from which the next were sought, in all. Work is measured
  /// by it, never by a clock.
  std::int64_t expansions = kUsualExpansions;
  std::uint64_t seed = 1;
};

struct GridSolution {
  enum class End {
    solved,
    no_solution,  ///< all that the agents can do was tried
    out_of_work   ///< none was found with so many expansions
  };
  End end = End::out_of_work;
  std::vector<std::vector<Cell>> ways;  ///< by agent, from tick 0 until it is at its goal for good
  std::vector<int> shortest;            ///< to each agent its ticks if it were alone
  std::int64_t cost = 0;                ///< ticks until they are at their goals for good, summed
  std::int64_t first_cost = 0;          ///< of the first solution
  std::int64_t least_cost = 0;          ///< no cost is below: the sum of `shortest`
  int makespan = 0;                     ///< ticks until all are
  std::int64_t expansions = 0;
  std::int64_t first_expansions = 0;
  std::vector<int> away;  ///< not solved: who was not at its goal where most were nearest to theirs
};

/// Ways for all agents of a problem that faults_of() finds nothing in: LaCAM for the first
/// solution, then large-neighbourhood search while expansions are left.
GridSolution solve(const GridProblem& problem, const GridQuery& query);

}  // namespace rubicon::grid
