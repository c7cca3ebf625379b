#include "interpreter/expand/evaluate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "src/motion/math/angles.hpp"

namespace rubicon::interpreter::expansion {

namespace {

using syntax::Dimension;
using syntax::Expression;
using Operator = Expression::Operator;

/// As in scripts: what differs by less is equal. Quotients of tenths are off by rounding, 4.8 / 1.6
/// by 4e-16, so whole numbers are those of conditions: floor(a) is 3 where a == 3 holds.
constexpr double kEqual = 1e-6;

/// Largest whole number that is counted with.
constexpr std::int64_t kMaxWhole = 1000000000;

const std::vector<std::string>& function_names() {
  static const std::vector<std::string> names{"abs", "min", "max", "floor", "mod", "sin", "cos"};
  return names;
}

Value number_value(double number, Dimension dimension = {}) {
  Value value;
  value.number = number;
  value.dimension = dimension;
  return value;
}

Value condition_value(bool holds) {
  Value value;
  value.kind = Value::Kind::condition;
  value.number = holds ? 1 : 0;
  return value;
}

/// Whether a bare number beside it says what it counts: 3 beside 2 m is 3 m, but what is 3 beside
/// 2 per h?
bool has_base_unit(Dimension dimension) {
  return dimension.time >= 0 || dimension == Dimension{1, 0, -1, 0} ||
         dimension == Dimension{0, 1, -1, 0};
}

/// Never -0.
double nearest_whole(double value) { return std::round(value) + 0.0; }

bool is_whole(double value) { return std::fabs(value - nearest_whole(value)) <= kEqual; }

/// The rest of a / b, with the sign of b. What is within kEqual of 0 or b, as it stands and as a
/// part of b, comes of rounding: nothing is left.
double rest_of(double a, double b) {
  double rest = std::fmod(a, b);
  if (rest != 0 && (rest < 0) != (b < 0)) rest += b;
  const double slack = kEqual * std::min(1.0, std::fabs(b));
  return std::min(std::fabs(rest), std::fabs(b - rest)) <= slack ? 0.0 : rest;
}

class Evaluation {
 public:
  Evaluation(Scope& scope, Diagnostics& diagnostics) : scope_(scope), diagnostics_(diagnostics) {}

  // Sums of thousands of terms are deep only on their left, so that side is walked without
  // recursion; nesting is bounded by the parser.
  std::optional<Value> run(const Expression& expression) {
    std::vector<const Expression*> open;
    const Expression* part = &expression;
    while (part->kind == Expression::Kind::binary) {
      open.push_back(part);
      part = part->operands[0].get();
    }
    std::optional<Value> result = operand(*part);
    for (; result && !open.empty(); open.pop_back()) {
      const Expression& node = *open.back();
      if (node.op == Operator::logical_and || node.op == Operator::logical_or) {
        result = logical(node, *result);
        continue;
      }
      const std::optional<Value> right = run(*node.operands[1]);
      result = right ? binary(node, *result, *right) : std::nullopt;
    }
    return result;
  }

  std::optional<Value> number(const Expression& expression) {
    std::optional<Value> value = run(expression);
    if (value && !is_number(expression, *value)) return std::nullopt;
    return value;
  }

  std::optional<bool> condition(const Expression& expression) {
    const std::optional<Value> value = run(expression);
    return value ? as_condition(expression, *value) : std::nullopt;
  }

 private:
  std::optional<Value> operand(const Expression& expression) {
    switch (expression.kind) {
      case Expression::Kind::number:
        return number_value(expression.number.value, expression.number.dimension);
      case Expression::Kind::parameter:
        return named(expression);
      case Expression::Kind::call:
        return call(expression);
      case Expression::Kind::negate:
      case Expression::Kind::plus: {
        std::optional<Value> value = number(*expression.operands[0]);
        if (value && expression.kind == Expression::Kind::negate) value->number = -value->number;
        return value;
      }
      case Expression::Kind::logical_not: {
        const std::optional<bool> holds = condition(*expression.operands[0]);
        if (!holds) return std::nullopt;
        return condition_value(!*holds);
      }
      case Expression::Kind::variable:
        return refuse(expression.span, "variables belong to behaviours and cannot stand here");
      case Expression::Kind::command:
        return refuse(expression.span,
                      fmt::format("'{}' is a command, not a value", expression.name.text()));
      case Expression::Kind::binary:
        break;
    }
    return std::nullopt;
  }

  std::optional<Value> named(const Expression& expression) {
    const std::optional<std::string> member =
        plain_name(expression.name.name, scope_, diagnostics_);
    const std::optional<std::string> owner =
        expression.name.body ? plain_name(*expression.name.body, scope_, diagnostics_)
                             : std::string();
    if (!member || !owner) return std::nullopt;
    const std::string name = owner->empty() ? *member : *owner + "." + *member;
    bool known = false;
    std::optional<Value> value = find_value(scope_, name, known);
    if (known) return value;
    if (const Scope* const plan = declared_later(scope_, name)) {
      Diagnostic diagnostic;
      diagnostic.code = "P23";
      diagnostic.span = at(expression.span);
      diagnostic.message =
          fmt::format("parameter '{}' is declared further down; {} knows those above it", name,
                      plan == &scope_ ? "a parameter" : "an imported plan");
      diagnostic.notes.push_back({plan->later.at(name), "declared here"});
      diagnostics_.add(std::move(diagnostic));
      return std::nullopt;
    }
    if (may_be_declared(scope_)) return std::nullopt;
    diagnostics_.error("P23", at(expression.span),
                       fmt::format("there is no parameter '{}'{}", name, near_name(scope_, name)));
    return std::nullopt;
  }

  std::optional<Value> call(const Expression& expression) {
    const std::string name = expression.name.text();
    const std::size_t wanted = name == "min" || name == "max" || name == "mod" ? 2 : 1;
    const auto& known = function_names();
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const std::string near = did_you_mean(name, known);
      return refuse(expression.span,
                    fmt::format("function '{}' cannot stand here{}; abs, min, max, floor, mod, sin "
                                "and cos can",
                                name, near.empty() ? "" : " (did you mean " + near + "?)"));
    }
    if (expression.operands.size() != wanted) {
      diagnostics_.error("F06", at(expression.span),
                         fmt::format("{} takes {} argument{}, found {}", name, wanted,
                                     wanted == 1 ? "" : "s", expression.operands.size()));
      return std::nullopt;
    }
    std::optional<Value> a = number(*expression.operands[0]);
    if (!a) return std::nullopt;
    if (wanted == 1) return function_of_one(name, expression, *a);
    std::optional<Value> b = number(*expression.operands[1]);
    if (!b || !agree(*expression.operands[1], *a, *b)) return std::nullopt;
    const Dimension dimension = a->dimension.is_bare() ? b->dimension : a->dimension;
    if (name == "mod") {
      if (b->number == 0) return zero_division(expression.span);
      return number_value(rest_of(a->number, b->number), dimension);
    }
    const bool takes_a = name == "min" ? a->number <= b->number : a->number >= b->number;
    return number_value(takes_a ? a->number : b->number, dimension);
  }

  std::optional<Value> function_of_one(const std::string& name, const Expression& expression,
                                       const Value& a) {
    if (name == "abs") return number_value(std::fabs(a.number), a.dimension);
    if (name == "floor") {
      return number_value(is_whole(a.number) ? nearest_whole(a.number) : std::floor(a.number),
                          a.dimension);
    }
    if (!a.dimension.is_bare() && !(a.dimension == Dimension{0, 1, 0, 0})) {
      diagnostics_.error(
          "F09", at(expression.operands[0]->span),
          fmt::format("{}(...) needs an angle, but the value is {}", name, kind_text(a)));
      return std::nullopt;
    }
    return number_value(name == "sin" ? math::sin_deg(a.number) : math::cos_deg(a.number));
  }

  std::optional<Value> binary(const Expression& node, const Value& left, const Value& right) {
    if (!is_number(*node.operands[0], left) || !is_number(*node.operands[1], right)) {
      return std::nullopt;
    }
    switch (node.op) {
      case Operator::multiply:
        return finite(node, left.number * right.number,
                      combined(left.dimension, right.dimension, 1));
      case Operator::divide:
        if (right.number == 0) return zero_division(node.op_span);
        return finite(node, left.number / right.number,
                      combined(left.dimension, right.dimension, -1));
      default:
        break;
    }
    if (!agree(node, left, right)) return std::nullopt;
    const Dimension dimension = left.dimension.is_bare() ? right.dimension : left.dimension;
    const double off = left.number - right.number;
    switch (node.op) {
      case Operator::add:
        return finite(node, left.number + right.number, dimension);
      case Operator::subtract:
        return finite(node, off, dimension);
      case Operator::equal:
        return condition_value(std::fabs(off) <= kEqual);
      case Operator::not_equal:
        return condition_value(std::fabs(off) > kEqual);
      case Operator::less:
        return condition_value(off < -kEqual);
      case Operator::less_equal:
        return condition_value(off <= kEqual);
      case Operator::greater:
        return condition_value(off > kEqual);
      default:
        return condition_value(off >= -kEqual);
    }
  }

  /// The right side is left out where the left decides.
  std::optional<Value> logical(const Expression& node, const Value& left) {
    const std::optional<bool> a = as_condition(*node.operands[0], left);
    if (!a) return std::nullopt;
    if (*a == (node.op == Operator::logical_or)) return condition_value(*a);
    const std::optional<bool> b = condition(*node.operands[1]);
    if (!b) return std::nullopt;
    return condition_value(*b);
  }

  bool is_number(const Expression& expression, const Value& value) {
    if (value.kind == Value::Kind::number) return true;
    diagnostics_.error("F09", at(expression.span),
                       fmt::format("expected a number, found {}", kind_text(value)));
    return false;
  }

  std::optional<bool> as_condition(const Expression& expression, const Value& value) {
    if (value.kind == Value::Kind::condition) return value.number != 0;
    diagnostics_.error("F09", at(expression.span),
                       fmt::format("expected a condition, found {}", kind_text(value)),
                       value.kind == Value::Kind::number ? "compare it: i > 1" : "");
    return std::nullopt;
  }

  /// Whether the two may be added or compared; F09 at the node.
  bool agree(const Expression& node, const Value& left, const Value& right) {
    const Span span = node.kind == Expression::Kind::binary ? node.op_span : node.span;
    if (left.dimension == right.dimension) return true;
    if (!left.dimension.is_bare() && !right.dimension.is_bare()) {
      diagnostics_.error(
          "F09", at(span),
          fmt::format("{} and {} cannot be added or compared", kind_text(left), kind_text(right)));
      return false;
    }
    const Value& with_kind = left.dimension.is_bare() ? right : left;
    if (has_base_unit(with_kind.dimension)) return true;
    diagnostics_.error(
        "F09", at(span),
        fmt::format("a plain number stands beside {}: write its unit", kind_text(with_kind)));
    return false;
  }

  std::optional<Value> finite(const Expression& node, double value, Dimension dimension) {
    if (std::isfinite(value)) return number_value(value, dimension);
    diagnostics_.error("F11", at(node.op_span), "the value is too large to be computed");
    return std::nullopt;
  }

  std::optional<Value> zero_division(Span span) {
    diagnostics_.error("F11", at(span), "division by zero");
    return std::nullopt;
  }

  std::optional<Value> refuse(Span span, std::string message) {
    diagnostics_.error("F10", at(span), std::move(message));
    return std::nullopt;
  }

  Span at(Span span) const {
    span.copy = scope_.copy;
    return span;
  }

  Scope& scope_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<Value> evaluate(const Expression& expression, Scope& scope,
                              Diagnostics& diagnostics) {
  return Evaluation(scope, diagnostics).run(expression);
}

std::optional<Value> evaluate_number(const Expression& expression, Scope& scope,
                                     Diagnostics& diagnostics) {
  return Evaluation(scope, diagnostics).number(expression);
}

std::optional<bool> evaluate_condition(const Expression& expression, Scope& scope,
                                       Diagnostics& diagnostics) {
  return Evaluation(scope, diagnostics).condition(expression);
}

std::optional<std::int64_t> evaluate_whole(const Expression& expression, std::string_view what,
                                           Scope& scope, Diagnostics& diagnostics) {
  const std::optional<Value> value = evaluate_number(expression, scope, diagnostics);
  if (!value) return std::nullopt;
  Span span = expression.span;
  span.copy = scope.copy;
  if (!value->dimension.is_bare()) {
    diagnostics.error(
        "F09", span,
        fmt::format("{} needs a plain number, but the value is {}", what, kind_text(*value)));
    return std::nullopt;
  }
  const double whole = nearest_whole(value->number);
  if (!is_whole(value->number) || std::fabs(whole) > static_cast<double>(kMaxWhole)) {
    diagnostics.error("P24", span,
                      fmt::format("{} needs a whole number of at most {}, found {}", what,
                                  kMaxWhole, number_text(value->number)));
    return std::nullopt;
  }
  return static_cast<std::int64_t>(whole);
}

std::optional<std::string> plain_name(const syntax::Name& name, Scope& scope,
                                      Diagnostics& diagnostics) {
  std::string text = name.text;
  for (const syntax::ExpressionPtr& index : name.indices) {
    const auto number =
        evaluate_whole(*index, "a number in the brackets of a name", scope, diagnostics);
    if (!number) return std::nullopt;
    if (*number < 0) {
      Span span = index->span;
      span.copy = scope.copy;
      diagnostics.error(
          "P24", span,
          fmt::format("the brackets of a name take numbers from 0 on, found {}", *number),
          "count from a higher number, or leave this one out with when (...) { ... }");
      return std::nullopt;
    }
    text += fmt::format("_{}", *number);
  }
  return text;
}

std::string kind_text(const Value& value) {
  if (value.kind == Value::Kind::text) return "a text";
  if (value.kind == Value::Kind::condition) return "a condition";
  return dimension_text(value.dimension);
}

std::string number_text(double value) {
  if (value == 0) return "0";
  // What counting left over in the last digits is nothing to tell: 3 * 1.1 m is 3.3 m.
  return fmt::format("{:.15g}", value);
}

}  // namespace rubicon::interpreter::expansion
