#pragma once

#include <cstdint>

#include "interpreter/program/world.hpp"

namespace rubicon::interpreter {

/// What one parameter has done in the run that goes on (src/motion/robot/trapezoid.hpp): steps one
/// after the other in one direction.
class MotionRun {
 public:
  /// `speed` > 0 per second; `acceleration` per second squared, 0: the speed is there at once.
  MotionRun(std::int32_t parameter, bool upwards, double speed, double acceleration)
      : parameter_(parameter), upwards_(upwards), speed_(speed), acceleration_(acceleration) {}

  /// Goes on by `distance` (m or degrees, > 0); how long that takes. Moments of the run are rounded
  /// to ticks, so that the durations of its steps add up to the time of the whole way.
  Ticks advance(double distance);

  /// How long it takes, after the last step, until the machine stands.
  Ticks rest() const;

  bool accelerates() const { return acceleration_ > 0; }
  bool is_of(std::int32_t parameter, bool upwards) const {
    return parameter_ == parameter && upwards_ == upwards;
  }

 private:
  std::int32_t parameter_;
  bool upwards_;
  double speed_;
  double acceleration_;
  double distance_ = 0;  ///< since its beginning
  double lost_ = 0;      ///< what rounding of the sum took from it (Kahan, CACM 8(1), 1965)
  Ticks time_ = 0;       ///< since its beginning, of the last step
};

}  // namespace rubicon::interpreter
