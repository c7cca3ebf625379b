#pragma once

#include <optional>
#include <span>

#include "src/motion/robot/chain_motion.hpp"
#include "src/motion/robot/robot_model.hpp"

namespace rubicon::robot {

/// A value that runs linearly over a step: at0 + rate s.
struct LinearValue {
  double at0 = 0;
  double rate = 0;
};

/// What a formula is while q runs linearly from q0 to q1, if it can be read off it that it runs
/// linearly too: sums of parameters, times constants.
std::optional<LinearValue> linear_value(const Formula& formula, std::span<const double> q0,
                                        std::span<const double> q1, std::span<const double> starts);

/// Bound of the speed dx/ds of a point of a body, by its distance from the body's origin:
/// origin + turning * r.
struct SpeedBound {
  double origin = 0;   ///< m
  double turning = 0;  ///< m per m of distance
};

/// Bounds the speed dx/ds and the acceleration d2x/ds2 over a step for a frame at the end of a
/// chain of elements, whose translations and angles all run linearly in s. The chain is built from
/// its base on, and what is known of a body is what its children begin with.
///
/// Rigorous: a vector that is constant (length l) behind rotations with the rates w1, w2, ... has
/// at most the acceleration (|w1| + |w2| + ...)^2 l; one that grows at the rate v, 2 (|w1| + ...) v
/// more; its speed is at most (|w1| + |w2| + ...) l + v. Rotations about the same axis in a row are
/// one with the sum of their rates, and do not turn what lies along their axis. Sums of differences
/// are enlarged for rounding.
class ChainBound {
 public:
  void append(const FrameElement& element, std::span<const double> q0, std::span<const double> q1,
              std::span<const double> starts);

  /// The bound; none where an element does not run linearly.
  std::optional<AccelerationBound> bound() const;
  std::optional<SpeedBound> speed() const;

 private:
  void append_translation(const LinearValue& x, const LinearValue& y, const LinearValue& z);
  void append_rotation(FrameElement::Kind axis, double rate);
  /// Upper bound (rad) of the rate of the rotations about the last axis.
  double last_rate() const;

  bool linear_ = true;
  double origin_ = 0;         ///< m: of the origin of the frame
  double origin_speed_ = 0;   ///< m
  double earlier_rates_ = 0;  ///< rad, of all rotations before those about the last axis
  FrameElement::Kind last_axis_ = FrameElement::Kind::trans;  ///< trans: no rotation yet
  double last_sum_ = 0;        ///< rad, signed: of the rotations about the last axis
  double last_magnitude_ = 0;  ///< rad, the sum of their absolute values
};

}  // namespace rubicon::robot
