#pragma once

#include <vector>

#include "src/fleets/layout/judge.hpp"

namespace rubicon::layout {

/// Takes a layout in if none of `front` beats it, and those out that it beats. One beats another if
/// it has no less modules, and neither longer trips nor fewer of them in an hour; of two that are
/// equal in that the one that is tried first. In whichever order they come, the same stay.
void add_to_front(std::vector<Layout>& front, Layout layout);

/// The most modules first; of those with as many the shortest mean trip. Left out are, from the
/// end, those that tell nothing new: one that stays has no less modules, and is at most half a
/// percent worse in trips. This holds for all that are left out.
std::vector<Layout> thinned(std::vector<Layout> front);

/// Those that no other beats, thinned.
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
