#pragma once

#include <span>
#include <vector>

#include "src/motion/guides/leg.hpp"

namespace rubicon::guides {

/// Seconds that a robot needs from q to the next configuration, all its parameters at once: those
/// of the slowest at full speed, of a vehicle for each corner (Langari 2015, eqs. 3.13-3.15).
/// Accelerations are left out.
double leg_time(const robot::RobotModel& model, const Leg& leg, std::span<const double> q,
                std::span<const double> next, bool loaded);

/// Metrics of a way, given as whole configurations with the start first (Langari 2015, 3.4). That
/// of a vehicle that steers goes from chord to chord.
struct WayMetrics {
  double roughness = 0;    ///< eq. 3.9: change of direction, summed; 0: straight
  double length = 0;       ///< m, eq. 3.10: what each parameter moves the tool by
  double motion_time = 0;  ///< s
};
WayMetrics way_metrics(const robot::RobotModel& model, const robot::Mounting& mounting,
                       const std::vector<std::vector<double>>& way, bool loaded,
                       double turn_radius = 0);

}  // namespace rubicon::guides
