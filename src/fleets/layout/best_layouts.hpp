#pragma once

#include <vector>

#include "src/fleets/layout/judge.hpp"

namespace rubicon::layout {

/// Each layout that no other beats, the one with the most modules first; of those with as many the
/// one with the shortest mean trip, then the one that was tried first. A layout beats another if it
/// has no less modules, and neither longer trips nor fewer of them in an hour: up to half a percent
/// of these is as good.
struct BestLayouts {
  int tried = 0;
  int worked = 0;  ///< hold modules that every gate reaches
  std::vector<Layout> best;
};

/// The most of modules that fit into the box round the hall if it were full of them.
inline constexpr double kMostModules = 100'000;

/// All choices of direction, lanes in aisles, cross aisles (0 to 2) and shift (eighths of a period,
/// and those at which a row or an aisle lies at a wall, or columns stand between two rows), judged.
/// Throws std::invalid_argument, in words for users, for a hall without gates, sizes that are not
/// above 0, a lane that is narrower than nothing fits, and more than kMostModules.
BestLayouts best_layouts(const Hall& hall, const Sizes& sizes);

}  // namespace rubicon::layout
