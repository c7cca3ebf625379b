#pragma once

#include <cstdint>
#include <vector>

#include "src/fleets/grid/next_moves.hpp"

namespace rubicon::grid {

/// What a search for where all agents go has come to.
struct LacamResult {
  enum class End {
    solved,     ///< `steps` leads from the starts to the goals
    exhausted,  ///< all that can be reached was seen: there is no solution
    stopped     ///< the limit was reached before
  };
  End end = End::stopped;
  std::vector<Configuration> steps;
  std::vector<int> away;  ///< not solved: who is not at its goal where most are nearest to theirs
  std::int64_t expansions = 0;
};

/// Lazy constraints addition search (K. Okumura, "LaCAM: search-based algorithm for quick
/// multi-agent pathfinding", AAAI 2023). Depth-first over where all agents are. Each of these
/// configurations is followed by others that NextMoves finds, at first freely, later with more and
/// more agents told where to go, until all followers were tried: so it is complete. Stops after
/// `limit` expansions. With `only` it is enough that this agent is at its goal: those of the others
/// are where they would like to be, and need not differ.
LacamResult lacam(const CellGraph& graph, Distances& distances, const Configuration& starts,
                  const Configuration& goals, std::uint64_t seed, std::int64_t limit,
                  int only = -1);

}  // namespace rubicon::grid
