#pragma once

#include "src/motion/travel/walker.hpp"

namespace rubicon::travel {

/// The methods, each with the obstacle on the right, from the start of a walker to its verdict.
TravelResult travel_bug1(Walker walker);
TravelResult travel_bug2(Walker walker);
TravelResult travel_visbug21(Walker walker);
TravelResult travel_pledge(Walker walker);
/// kSimple, kTangent or kAce.
TravelResult travel_tangent(Walker walker, Method method);

/// D + 1.5 times the perimeters of the outlines that come within D of the destination (Lumelsky and
/// Stepanov 1987).
Bound bug1_bound(const Outline& outline, const LatticePoint& start,
                 const LatticePoint& destination);
/// D + the sum over outlines of the perimeter times half the points where the line from start to
/// destination crosses it (Lumelsky and Stepanov 1987), rounded up: where the outline encloses the
/// start or the destination their number is odd.
Bound bug2_bound(const Outline& outline, const LatticePoint& start,
                 const LatticePoint& destination);

}  // namespace rubicon::travel
