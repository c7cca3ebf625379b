#pragma once

#include <cstdint>
#include <vector>

#include "src/fleets/grid/grid_problem.hpp"

namespace rubicon::bench {

/// What LaCAM found, written from its paper: the baseline for first solutions.
struct PaperSolution {
  bool solved = false;
  std::int64_t cost = 0;   ///< ticks until all are at their goals for good, summed
  std::int64_t nodes = 0;  ///< configurations that were kept
};

/// K. Okumura, "LaCAM: search-based algorithm for quick multi-agent pathfinding" (AAAI 2023),
/// algorithm 1, with PIBT for the next configuration and a known configuration put back on top of
/// the stack. Without the swap of the later paper, and with containers of the standard library.
/// Nothing of it is shared with src/fleets/grid but the problem. Gives up after `limit`
/// configurations.
PaperSolution lacam_of_the_paper(const grid::GridProblem& problem, std::uint64_t seed,
                                 std::int64_t limit);

}  // namespace rubicon::bench
