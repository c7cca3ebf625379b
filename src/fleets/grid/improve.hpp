#pragma once

#include <cstdint>
#include <vector>

#include "src/fleets/grid/distances.hpp"
#include "src/fleets/grid/stay_table.hpp"

namespace rubicon::grid {

/// Makes ways cheaper, where the cost is the sum of the ticks until each agent is at its goal for
/// good: large-neighbourhood search (J. Li, Z. Chen, D. Harabor, P. Stuckey, S. Koenig, "Anytime
/// multi-agent path finding via large neighborhood search", IJCAI 2021). Again and again some
/// agents plan anew, one after the other, each as early as it can between all others; what is not
/// worse is kept. How many agents, and which (those in the way of a late one, those who use one
/// cell, any), is chosen by what helped so far. Ends after `limit` expansions, or when the cost is
/// `bound`. Returns the expansions that it took.
std::int64_t improve(const CellGraph& graph, Distances& distances, std::vector<CellWay>& ways,
                     std::int64_t bound, std::uint64_t seed, std::int64_t limit);

}  // namespace rubicon::grid
