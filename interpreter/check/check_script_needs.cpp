#include "interpreter/check/check_script_needs.hpp"

#include <fmt/format.h>

#include "interpreter/check/check_script_expression.hpp"

namespace rubicon::interpreter::script_check {

bool ValueNeeds::value(ValueKind wanted, const syntax::Expression& value, ValueKind kind,
                       const std::string& who, Span place) {
  if (kind == ValueKind::condition) {
    diagnostics_.error("S12", place, who + " needs a number, not a condition");
    return false;
  }
  if (fits(kind, wanted)) return true;
  if (wanted == ValueKind::place) {
    diagnostics_.error("S12", value.span,
                       fmt::format("{} needs a place on the way, not {}", who, kind_text(kind)),
                       "keep one in a variable: var(hit) = here();");
    return false;
  }
  if (const syntax::Expression* literal = misfit_literal(value, wanted)) {
    wrong_unit(*literal, fmt::format("{} needs {}", who, kind_text(wanted)));
  } else {
    diagnostics_.warning(
        "W01", place,
        fmt::format("{} needs {}, but the value is {}", who, kind_text(wanted), kind_text(kind)));
  }
  return false;
}

void ValueNeeds::direction(const syntax::Expression& value, ValueKind kind, const std::string& who,
                           const std::string& parameter, Span place, const std::string& if_zero) {
  if (kind == ValueKind::direction || kind == ValueKind::unknown) return;
  if (kind == ValueKind::condition) {
    diagnostics_.error("S12", place, who + " needs a direction, not a condition");
    return;
  }
  if (const syntax::Expression* literal = misfit_literal(value, ValueKind::direction)) {
    wrong_unit(*literal, who + " needs a direction");
    return;
  }
  const std::optional<double> constant = constant_value(value);
  if (constant && *constant == 0) {
    diagnostics_.warning("W07", place, "direction 0: " + if_zero);
    return;
  }
  // Any other number may be a sign that was computed; a literal says plainly what it is.
  const bool sign = !constant || *constant == 1 || *constant == -1;
  if (kind == ValueKind::number && sign) return;
  diagnostics_.warning(
      "W02", place,
      fmt::format("{} needs a direction; did you mean dir({}, ...)?", who, parameter));
}

void ValueNeeds::wrong_unit(const syntax::Expression& literal, const std::string& need) {
  diagnostics_.error("S15", literal.span,
                     fmt::format("'{}' is {}, but {}", number_text(literal.number),
                                 kind_text(kind_of_unit(literal.number.unit)), need));
}

}  // namespace rubicon::interpreter::script_check
