#pragma once

#include <span>
#include <vector>

#include "src/motion/coverage/grid.hpp"

namespace rubicon::coverage {

/// A segment parallel to an axis.
struct Cut {
  Point a;
  Point b;
};

/// Cuts an orthogonal region into as few rectangles as can be. The inside of the rings is on their
/// left: the outline counter-clockwise, holes clockwise; they are simple and do not touch.
/// Chords between reflex corners on one line save a rectangle each; a largest set of them without
/// common points is found by bipartite matching; then the rest of the reflex corners is cut along x
/// (Lipski, Lodi, Luccio, Mugnai, Pagli, Fundamenta Informaticae 2, 1979; Ohtsuki 1982). With c
/// corners of more than 180 degrees, h holes and m chords there are c - m + 1 - h rectangles.
/// In the order of their lowest, then leftmost corner.
std::vector<Box> fewest_rectangles(std::span<const Ring> rings);

/// The cuts that part the region into those rectangles.
std::vector<Cut> cuts_of_fewest_rectangles(std::span<const Ring> rings);

}  // namespace rubicon::coverage
