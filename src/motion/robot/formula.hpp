#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rubicon::robot {

/// One operation of a compiled transform function, in postfix order.
struct FormulaOp {
  enum class Kind : std::uint8_t {
    constant,
    parameter,
    step,
    start,
    add,
    subtract,
    multiply,
    divide,
    negate,
    sin,
    cos
  };
  Kind kind = Kind::constant;
  int index = 0;     ///< parameter index for parameter, step (p_s) and start (p_c)
  double value = 0;  ///< for constant
};

/// The values a formula reads; spans over all parameters of the robot, in file units (m, degrees).
struct FormulaInput {
  std::span<const double> q;       ///< control parameters
  std::span<const double> steps;   ///< p_s; may be empty where the formula has no step
  std::span<const double> starts;  ///< p_c
};

/// Sine and cosine of the angle (degrees) asked for last.
struct TrigonometryMemo {
  double degrees = 0;
  double sine = 0;
  double cosine = 1;
};

/// Enclosure of a formula and of its first two derivatives in s over an interval of s.
struct Interval {
  double lower = 0;
  double upper = 0;
};
struct Enclosure {
  Interval value;
  Interval first;   ///< d/ds
  Interval second;  ///< d2/ds2
};

/// A transform function of a motion rule, a frame element or a derived parameter: sums, products,
/// sin and cos (degrees) of parameters, their steps and their start values (1995 paper, 2.3). An
/// empty formula is 0.
struct Formula {
  std::vector<FormulaOp> code;

  double evaluate(const FormulaInput& input) const;

  /// The same; the rules of one motion step share sines and cosines through `memo`.
  double evaluate(const FormulaInput& input, TrigonometryMemo& memo) const;

  /// Derivative by parameter `index`, all else fixed.
  double derivative(const FormulaInput& input, int index) const;

  /// Derivative while every parameter i changes at the rate direction[i] (chain rule through
  /// derived parameters).
  double derivative(const FormulaInput& input, std::span<const double> direction) const;

  /// Rigorous bounds while q moves linearly from q0 to q1 and s runs over [s0, s1] of [0, 1].
  Enclosure enclose(std::span<const double> q0, std::span<const double> q1,
                    std::span<const double> starts, double s0, double s1) const;

  bool depends_on_parameter(int index) const;
  bool depends_on_step(int index) const;
};

Formula constant_formula(double value);
Formula parameter_formula(int index);

}  // namespace rubicon::robot
