#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubicon::verify {

/// All values between two bounds.
struct Range {
  double lower = 0;
  double upper = 0;
};

/// What the names in a formula stand for, by parameter: value, step (`_s`), start value (`_c`).
struct FormulaValues {
  std::span<const double> values;
  std::span<const double> steps;  ///< empty: all 0
  std::span<const double> starts;
};

/// A transform function as a trace header writes it: + - * /, sin and cos of degrees, numbers, and
/// parameters by display name, with _s their step, with _c their start value.
class Formula {
 public:
  Formula() = default;  ///< 0

  /// Throws UnreadableInput if the text is no formula over these parameters.
  static Formula parse(std::string_view text, const std::vector<std::string>& parameters);

  double value(const FormulaValues& at) const;

  /// Encloses all values while every parameter runs through its range; steps are 0. Loose where a
  /// parameter occurs twice, and as narrow as wanted for narrow ranges. Rounding of the last digit
  /// is not enclosed.
  Range range(std::span<const Range> parameters, std::span<const double> starts) const;

  bool uses(std::size_t parameter) const;

 private:
  friend class FormulaParser;
  enum class Kind { number, value, step, start, add, subtract, multiply, divide, negate, sin, cos };
  struct Op {
    Kind kind = Kind::number;
    double number = 0;
    std::size_t parameter = 0;
  };
  std::vector<Op> code_;  ///< operands before operators
};

/// An elementary transform: a move by (a, b, c) metres, or a turn by `a` degrees about x, y or z.
struct FrameElement {
  enum class Kind { trans, rotx, roty, rotz };
  Kind kind = Kind::trans;
  Formula a, b, c;
};

/// A frame as a trace header writes it: trans(x, 0, z) * rotz(theta). Throws UnreadableInput.
std::vector<FrameElement> parse_frame(std::string_view text,
                                      const std::vector<std::string>& parameters);

}  // namespace rubicon::verify
