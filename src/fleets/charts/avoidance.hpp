#pragma once

#include <vector>

#include "src/fleets/charts/chart.hpp"

namespace rubicon::charts {

struct AvoidanceSettings {
  /// Arrivals at a node that are less apart than this are in conflict. The worked example of the
  /// paper holds with anything up to 5 s.
  Nanoseconds tolerance = 5 * kSecond;
  Nanoseconds delay = 5 * kSecond;      ///< by which who yields at a node is moved, each time
  Nanoseconds clearance = 5 * kSecond;  ///< between two robots that would meet head-on
  std::int64_t most_moves = 100'000;    ///< of charts, then the result is not settled
};

/// Who goes first: the robots, those with right of way first. By priority, then the earlier start,
/// then the order of the plan. Two exceptions, ours: a robot that is out of its lane goes before
/// all; and one that already is where another is about to drive against the direction, or stands at
/// the node before it, goes right before that one, for it cannot be elsewhere.
std::vector<RobotIndex> right_of_way(const std::vector<Robot>& robots,
                                     const std::vector<Chart>& charts);

/// Moves arrival times until no two robots are in conflict at a node, and none meets one head-on
/// that drives against the direction of a lane (the Blackmon paper, "Background", "Bypass Planning"
/// and the steps of its example). General avoidance first, then that for bypasses with each robot
/// by right of way, again until nothing changes. Times only ever become later, and who has right of
/// way is never moved by who has not, so this ends. Which robot is named first makes no difference
/// where priorities or starts differ.
///
/// A robot that is out of its lane is not asked to wait before it is in a lane again. One that
/// comes to a node against the direction of a lane waits at the node, for it has to clear the lane.
///
/// Adds a record of kind kYields for each move. False where `most_moves` did not suffice, or times
/// went beyond 285 years; the charts are then not free of conflicts. Throws std::invalid_argument
/// for a tolerance below 0, a delay or a clearance that is not above 0, and any of them beyond a
/// year.
bool avoid_conflicts(const std::vector<Robot>& robots, std::vector<Chart>& charts,
                     const AvoidanceSettings& settings, std::vector<Record>& records);

}  // namespace rubicon::charts
