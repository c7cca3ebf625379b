#include "interpreter/check/check_script_values.hpp"

#include <vector>

namespace rubicon::interpreter::script_check {

using syntax::Expression;

std::string kind_text(ValueKind kind) {
  switch (kind) {
    case ValueKind::unknown:
      return "a value";
    case ValueKind::number:
      return "a number";
    case ValueKind::length:
      return "a length";
    case ValueKind::angle:
      return "an angle";
    case ValueKind::time:
      return "a time";
    case ValueKind::mass:
      return "a mass";
    case ValueKind::speed:
      return "a speed";
    case ValueKind::turn_rate:
      return "a turning speed";
    case ValueKind::rate:
      return "an hourly rate";
    case ValueKind::direction:
      return "a direction";
    case ValueKind::place:
      return "a place on the way";
    case ValueKind::condition:
      return "a condition";
  }
  return "";
}

ValueKind kind_of_unit(syntax::UnitKind unit) {
  switch (unit) {
    case syntax::UnitKind::none:
      return ValueKind::number;
    case syntax::UnitKind::length:
      return ValueKind::length;
    case syntax::UnitKind::angle:
      return ValueKind::angle;
    case syntax::UnitKind::time:
      return ValueKind::time;
    case syntax::UnitKind::mass:
      return ValueKind::mass;
    case syntax::UnitKind::density:
    case syntax::UnitKind::acceleration:
    case syntax::UnitKind::turn_acceleration:
      return ValueKind::unknown;
    case syntax::UnitKind::speed:
      return ValueKind::speed;
    case syntax::UnitKind::turn_rate:
      return ValueKind::turn_rate;
    case syntax::UnitKind::per_hour:
      return ValueKind::rate;
    case syntax::UnitKind::compound:
      break;
  }
  return ValueKind::unknown;
}

std::optional<ValueKind> kind_of_parameter(const std::string& name) {
  if (name == "x" || name == "y" || name == "z") return ValueKind::length;
  if (name == "psi" || name == "phi" || name == "theta") return ValueKind::angle;
  return std::nullopt;
}

namespace {

// In arithmetic a direction is a plain number.
ValueKind as_number(ValueKind kind) {
  return kind == ValueKind::direction ? ValueKind::number : kind;
}

}  // namespace

ValueKind joined(ValueKind a, ValueKind b) { return a == b ? a : ValueKind::unknown; }

ValueKind sum_kind(ValueKind a, ValueKind b) {
  a = as_number(a);
  b = as_number(b);
  if (a == ValueKind::unknown || b == ValueKind::unknown) return ValueKind::unknown;
  if (a == ValueKind::number) return b;
  if (b == ValueKind::number) return a;
  return joined(a, b);
}

ValueKind product_kind(ValueKind a, ValueKind b) {
  a = as_number(a);
  b = as_number(b);
  if (a == ValueKind::number) return b;
  if (b == ValueKind::number) return a;
  return ValueKind::unknown;
}

ValueKind quotient_kind(ValueKind a, ValueKind b) {
  a = as_number(a);
  b = as_number(b);
  if (b == ValueKind::number) return a;
  if (a == b && a != ValueKind::unknown) return ValueKind::number;
  return ValueKind::unknown;
}

bool fits(ValueKind kind, ValueKind wanted) {
  const bool known = kind != ValueKind::unknown && wanted != ValueKind::unknown;
  if (known && (kind == ValueKind::place || wanted == ValueKind::place)) return kind == wanted;
  return kind == wanted || kind == ValueKind::unknown || kind == ValueKind::number ||
         wanted == ValueKind::unknown;
}

std::optional<double> constant_value(const Expression& expression) {
  double sign = 1;
  const Expression* part = &expression;
  while (part->kind == Expression::Kind::negate || part->kind == Expression::Kind::plus) {
    if (part->kind == Expression::Kind::negate) sign = -sign;
    part = part->operands[0].get();
  }
  if (part->kind != Expression::Kind::number) return std::nullopt;
  return sign * part->number.value;
}

const Expression* misfit_literal(const Expression& expression, ValueKind wanted) {
  std::vector<const Expression*> open{&expression};
  while (!open.empty()) {
    const Expression* part = open.back();
    open.pop_back();
    switch (part->kind) {
      case Expression::Kind::number:
        if (!fits(kind_of_unit(part->number.unit), wanted)) return part;
        break;
      case Expression::Kind::negate:
      case Expression::Kind::plus:
        open.push_back(part->operands[0].get());
        break;
      case Expression::Kind::binary:
        if (part->op == Expression::Operator::add || part->op == Expression::Operator::subtract) {
          open.push_back(part->operands[1].get());
          open.push_back(part->operands[0].get());
        }
        break;
      default:
        break;
    }
  }
  return nullptr;
}

}  // namespace rubicon::interpreter::script_check
