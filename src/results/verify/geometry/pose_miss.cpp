#include "src/results/verify/geometry/pose_miss.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/motion/math/angles.hpp"

namespace rubicon::verify {

namespace {

double turned_deg(const Pose& is, const Pose& should, int free_axis) {
  if (free_axis == kAllFree) return 0;
  if (free_axis == kNothingFree) {
    return math::rotation_angle_deg(is.linear().transpose() * should.linear());
  }
  const Vec3 a = is.linear().col(free_axis);
  const Vec3 b = should.linear().col(free_axis);
  return math::atan2_deg(a.cross(b).norm(), a.dot(b));
}

}  // namespace

PoseMiss pose_miss(const Pose& is, const Pose& should, int free_axis) {
  return {(is.translation() - should.translation()).norm(), turned_deg(is, should, free_axis)};
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
