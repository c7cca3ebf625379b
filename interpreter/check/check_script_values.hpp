#pragma once

#include <optional>
#include <string>

#include "interpreter/syntax/syntax.hpp"
#include "src/motion/robot/robot_model.hpp"

/// Kinds of values: what a number measures. Checked statically only; at run time every value is a
/// double.
namespace rubicon::interpreter::script_check {

enum class ValueKind {
  unknown,  ///< not known, or a variable of mixed kinds: fits everywhere
  number,   ///< no unit: fits wherever a value is wanted
  length,
  angle,
  time,
  mass,
  speed,
  turn_rate,
  rate,
  direction,  ///< a number whose sign matters
  place,      ///< on the way, as here() gives it: fits nowhere else
  condition
};

/// `a length`, `an angle`, with its article.
std::string kind_text(ValueKind kind);

/// The kind a literal's unit gives it.
ValueKind kind_of_unit(syntax::UnitKind unit);

/// The kind of a control parameter: psi, phi, theta are angles, x, y, z lengths; nothing for
/// another name.
std::optional<ValueKind> kind_of_parameter(const std::string& name);

/// Of a variable that was assigned both; and of alternatives.
ValueKind joined(ValueKind a, ValueKind b);

/// Of a sum or difference of two values that may be added.
ValueKind sum_kind(ValueKind a, ValueKind b);
ValueKind product_kind(ValueKind a, ValueKind b);
ValueKind quotient_kind(ValueKind a, ValueKind b);

/// Whether a value of this kind may stand where `wanted` (not direction, not condition) is needed.
bool fits(ValueKind kind, ValueKind wanted);

/// The value of an expression of literals and signs; nothing for any other.
std::optional<double> constant_value(const syntax::Expression& expression);

/// The first literal with a unit that makes the sum `expression` something else than `wanted`; null
/// if there is none.
const syntax::Expression* misfit_literal(const syntax::Expression& expression, ValueKind wanted);

}  // namespace rubicon::interpreter::script_check
