#include "src/simulation/taskplan/goal_holds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::taskplan {

namespace {

/// Fraction of a step within which a value counts as met (LANGUAGE section 4).
constexpr double kStepFraction = 1e-6;
/// m, degrees: so much more than `within` allows is rounding.
constexpr double kRounding = 1e-6;

bool frame_holds(const robot::RobotModel& model, const robot::Mounting& mounting,
                 std::span<const double> q, const math::Pose& X_WG,
                 const interpreter::Within& within, robot::FreeTurn free) {
  robot::PoseTolerance tolerance;
  if (within.length >= 0) tolerance.position = within.length;
  for (const auto& [index, value] : within.values) {
    if (!model.parameters[static_cast<std::size_t>(index)].rotation) continue;
    tolerance.orientation = std::max(tolerance.orientation, math::radians(value));
  }
  const math::Pose X_WT = robot::tool_pose(model, mounting, q);
  const double off = (X_WT.translation() - X_WG.translation()).norm();
  const double turned = robot::turn_off_deg(X_WT.linear(), X_WG.linear(), free);
  return off <= tolerance.position + kRounding &&
         turned <= math::degrees(tolerance.orientation) + kRounding;
}

}  // namespace

bool goal_holds(const robot::RobotModel& model, const robot::Mounting& mounting,
                std::span<const double> q, const interpreter::GoalSpec& goal,
                const interpreter::Within& within, robot::FreeTurn free) {
  if (goal.X_WG && !frame_holds(model, mounting, q, *goal.X_WG, within, free)) return false;
  return std::all_of(goal.values.begin(), goal.values.end(), [&](const auto& named) {
    const auto& [index, value] = named;
    const robot::Parameter& parameter = model.parameters[static_cast<std::size_t>(index)];
    const double now = q[static_cast<std::size_t>(index)];
    const double off =
        robot::reduced(parameter, robot::nearest_turn_equivalent(parameter, value, now) - now);
    double tolerance = kStepFraction * parameter.quantum;
    for (const auto& [within_index, allowed] : within.values) {
      if (within_index == index) tolerance += allowed;
    }
    return std::fabs(off) <= tolerance;
  });
}

}  // namespace rubicon::taskplan
