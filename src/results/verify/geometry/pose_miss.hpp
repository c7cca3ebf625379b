#pragma once

#include <optional>
#include <string>

#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// How far a pose may be from another.
struct GoalTolerance {
  double off = 0;         ///< m
  double turned_deg = 0;  ///< degrees
};

/// How far a pose is from where it should be.
struct PoseMiss {
  double off = 0;         ///< m
  double turned_deg = 0;  ///< degrees

  bool within(const GoalTolerance& allowed) const {
    return off <= allowed.off && turned_deg <= allowed.turned_deg;
  }
};

/// `free_axis`: of the tool, about which any turn is as good (SceneTask).
PoseMiss pose_miss(const Pose& is, const Pose& should, int free_axis = kNothingFree);

/// "12.0 mm and 0.500 degrees".
std::string text_of(const PoseMiss& miss);

/// Poses may differ by so much that should be the same. Reason: a chain of poses is multiplied in
/// another order than the engine's.
inline constexpr GoalTolerance kSamePose{1e-6, 1e-5};

/// How near to a goal frame a task must come. Where the header does not tell: 1 mm and 0.1 degrees.
GoalTolerance goal_tolerance(const SceneRobot& robot, const std::optional<SceneWithin>& within);

}  // namespace rubicon::verify
