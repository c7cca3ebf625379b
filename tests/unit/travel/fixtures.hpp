#pragma once

#include "tests/unit/travel/travel_worlds.hpp"

namespace rubicon::travel {

/// An obstacle that moves with a velocity from one time to another, else stands.
Obstacle moving(std::string name, Corners corners, double from, double to, const Vec2& velocity);
Obstacle standing(std::string name, Corners corners);

/// The scenes of Lee and Adams' figures, with coordinates of our own: the paper gives none.
TravelQuery figure_1();
TravelQuery figure_3();
TravelQuery figure_4b();
/// A closed room; `opens`: the thing in its door drives away.
TravelQuery figure_4c(bool opens);
TravelQuery figure_5();
/// A convex obstacle that drives along with the robot, between it and the destination, for ever.
TravelQuery figure_2a();
/// A field of convex obstacles that touch round the destination's side.
TravelQuery figure_2b();

}  // namespace rubicon::travel
