#pragma once

#include "bench/swept_scene.hpp"

namespace rubicon::bench {

/// Top (m) of the walls of the last storey, where its roof planks come to lie.
inline constexpr double kTopOfWalls = 14.8;
/// Half extents (m) of a hollow-core plank.
inline const Vec3 kPlankHalf(0.6, 3.6, 0.1);

/// A precast building of 5 storeys with 8 units each, two rows beside a corridor, north of a crane
/// that stands at the origin. A unit is that of taskplans/unit.plan, doors and windows closed: 10
/// floor planks, 15 walls, 10 roof planks, balcony, stair: 37 panels. Built up to the walls of the
/// last storey: 1,400 panels and the ground. `load` is a plank; there are no steps yet.
SweptScene residential_site();

/// Where the centres of the 80 roof planks come to lie (their length is along y).
std::vector<Vec3> roof_places();

}  // namespace rubicon::bench
