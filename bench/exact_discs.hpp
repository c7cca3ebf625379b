#pragma once

#include <optional>
#include <vector>

#include "src/fleets/traffic/one_shot.hpp"

namespace rubicon::bench {

/// The least sum of arrivals of discs on a roadmap in continuous time, by conflict-based search
/// (A. Andreychuk and others, "Multi-agent pathfinding with continuous time", 2022), written from
/// the paper; s. Discs wait at nodes and drive straight at their speeds; between those of two that
/// meet, one may not begin its move at such times. Where one of them waits, what the paper forbids
/// together may be allowed in a solution; here a part of the time is forbidden to the one that
/// waits, and to the other what meets all of that part, which loses none.
/// Nothing if it takes more than so many nodes of the tree.
std::optional<double> exact_discs(const lanes::LaneNetwork& network, double diameter,
                                  const std::vector<traffic::Trip>& trips, int most_nodes);

}  // namespace rubicon::bench
