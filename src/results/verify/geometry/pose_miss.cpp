#include "src/results/verify/geometry/pose_miss.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rubicon::verify {

PoseMiss pose_miss(const Pose& is, const Pose& should) {
  return {(is.translation() - should.translation()).norm(),
          math::rotation_angle_deg(is.linear().transpose() * should.linear())};
}

std::string text_of(const PoseMiss& miss) {
  return fmt::format("{:.1f} mm and {:.3f} degrees", miss.off * 1000, miss.turned_deg);
}

GoalTolerance goal_tolerance(const SceneRobot& robot, const std::optional<SceneWithin>& within) {
  if (!within) return {1e-3, 0.1};
  // Where a plan gives no tolerance the engine's is 1e-6 m and 1e-6 radians.
  GoalTolerance allowed{2e-6, 1e-4};
  allowed.off += std::max(within->length, 0.0);
  for (const auto& [name, value] : within->values) {
    const bool turns =
        std::any_of(robot.parameters.begin(), robot.parameters.end(),
                    [&](const SceneParameter& each) { return each.rotation && each.name == name; });
    if (turns) allowed.turned_deg = std::max(allowed.turned_deg, value + kSamePose.turned_deg);
  }
  return allowed;
}

}  // namespace rubicon::verify
