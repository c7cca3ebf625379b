#pragma once

#include <span>
#include <string>
#include <vector>

#include "src/results/verify/replay/motion_run.hpp"

namespace rubicon::verify {

/// An accepted attempt: a robot's values before and after, the parameters that it moved.
struct StepQuery {
  std::span<const double> before;
  std::span<const double> after;
  std::span<const int> moved;
  bool loaded = false;
  Ticks duration = 0;
  MotionRun run = {};  ///< that goes on when the step begins
  Ticks least = 0;     ///< it lasts so long at least: where the tool works it goes no faster
};

struct StepResult {
  /// Values that every parameter reaches in a straight line; angles not reduced to half a turn.
  std::vector<double> reached;
  std::vector<std::string> faults;  ///< sentences; empty: the robot's rules allow the step
  MotionRun run;                    ///< with this step
  bool goes_on = false;             ///< it is the one of before
};

/// Checks a step against the rules of the header: there are steps of the moved parameters, none
/// longer than allowed, for which the rules give all values after it, all within range; and it
/// lasts as long as the slowest of them, or `least`, from where in its run each begins. The steps
/// are found from the values by Newton's method (one round for the rules robots have, which are
/// linear in the steps).
StepResult check_step(const SceneRobot& robot, const StepQuery& query);

/// The values a robot starts with: derived ones computed, angles within half a turn.
std::vector<double> start_values(const SceneRobot& robot);

/// Metres or degrees by which values may differ that should be the same. Reason: the rules are
/// evaluated in another order than the engine's.
inline constexpr double kValueSlack = 1e-7;

}  // namespace rubicon::verify
