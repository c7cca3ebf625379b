#pragma once

namespace rubicon::robot {

/// How long a run takes: steps of a parameter one after the other in one direction, from rest to
/// rest. The speed rises at one rate up to its highest, stays, and falls at the same rate (a
/// trapezoid over time; a triangle where the way is too short for the highest speed). Source: the
/// equations of uniformly accelerated motion.
///
/// Distances from the beginning of the run in m or degrees, `speed` per second, `acceleration` per
/// second squared, all > 0; seconds. Only sums, quotients and square roots, which IEEE 754 rounds
/// alike everywhere.

/// Until the machine has gone so far, as if it went on for ever: sqrt(2 d / a) while it gains speed
/// (d < v^2 / 2a), then d / v + v / 2a.
double time_under_way(double distance, double speed, double acceleration);

/// Until it stands again at that distance: 2 sqrt(d / a) where it never has its highest speed
/// (d < v^2 / a), else d / v + v / a.
double time_to_rest(double distance, double speed, double acceleration);

}  // namespace rubicon::robot
