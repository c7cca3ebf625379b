#pragma once

#include <vector>

#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// m or degrees by which the steps found from the values of a trace may miss those that were made
/// (step_rules stops at this residual). Consequence: a run of 1000 steps is held to about 2 us.
inline constexpr double kDistanceSlack = 1e-9;

/// One parameter of a run.
struct RunPart {
  int parameter = -1;
  double gone = 0;  ///< since the run began, m or degrees; its sign is the direction
};

/// What moves since it last stood: steps of the same parameters in the same directions. Empty where
/// none of them has an acceleration: such a machine stands at once.
struct MotionRun {
  std::vector<RunPart> parts;
  int steps = 0;
  bool loaded = false;

  bool is_of_same_parts(const MotionRun& other) const;
};

/// How long something takes, and by how much rounding may change that.
struct RunTime {
  Ticks time = 0;
  Ticks slack = 0;
};

/// Of a parameter of a run: its last `step` (signed, > 0 or < 0), after `gone` m or degrees in the
/// same direction in `steps` steps. Speed rises at the rate `acceleration` from nothing; without an
/// acceleration it is there at once.
RunTime step_time(const SceneParameter& parameter, bool loaded, double gone, int steps,
                  double step);

/// From the last step of the run until its machine stands: the longest of its parts.
RunTime rest_time(const SceneRobot& robot, const MotionRun& run);

}  // namespace rubicon::verify
