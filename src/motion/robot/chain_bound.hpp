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

/// Bounds the acceleration d2x/ds2 over a step for a frame at the end of a
/// chain of elements, whose translations and angles all run linearly in s. The chain is built from
/// its base on, and what is known of a body is what its children begin with.
///
/// Rigorous: a vector that is constant (length l) behind rotations with the rates w1, w2, ... has
/// at most the acceleration (|w1| + |w2| + ...)^2 l; one that grows at the rate v, 2 (|w1| + ...) v
/// more. Rotations about the same axis in a row are one with the sum of their rates, and do not
/// turn what lies along their axis. Sums of differences are enlarged for rounding.
class ChainBound {
 public:
  void append(const FrameElement& element, std::span<const double> q0, std::span<const double> q1,
              std::span<const double> starts);
  /// The same for elements that are known to run linearly: a rotation about axis 0, 1 or 2 at a
  /// rate (rad), a translation (m), a constant translation with these lengths (m) along the axis of
  /// the last rotation and across it, and a constant rotation about any axis.
  void append_turn(int axis, double rate);
  void append_translation(const Vec3& at0, const Vec3& rate);
  void append_constant(double along, double across);
  void append_constant_turn() { end_row(); }

  /// The bound; none where an element does not run linearly.
  std::optional<AccelerationBound> bound() const;

 private:
  /// A vector with these lengths (m) along the last axis and across it, which grow at these rates.
  void append_lengths(double along, double across, double along_grows, double across_grows);
  void end_row();
  /// Upper bound (rad) of the rate of the rotations about the last axis.
  double last_rate() const;

  bool linear_ = true;
  double origin_ = 0;          ///< m: of the origin of the frame
  double earlier_rates_ = 0;   ///< rad, of all rotations before those about the last axis
  int last_axis_ = -1;         ///< -1: none, or it has been turned since
  double last_sum_ = 0;        ///< rad, signed: of the rotations about the last axis
  double last_magnitude_ = 0;  ///< rad, the sum of their absolute values
};

}  // namespace rubicon::robot
