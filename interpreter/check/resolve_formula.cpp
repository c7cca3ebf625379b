#include "interpreter/check/resolve_formula.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace rubicon::interpreter {

namespace {

using robot::Formula;
using robot::FormulaOp;
using script_check::ValueKind;
using syntax::Expression;

FormulaOp operation(FormulaOp::Kind kind) {
  FormulaOp op;
  op.kind = kind;
  return op;
}

class FormulaResolver {
 public:
  FormulaResolver(FormulaNames& names, Diagnostics& diagnostics)
      : names_(names), diagnostics_(diagnostics) {}

  std::optional<ResolvedFormula> run(const Expression& expression) {
    ResolvedFormula result = resolve(expression);
    if (failed_) return std::nullopt;
    return result;
  }

 private:
  // Sums of thousands of terms are deep only on their left, so that side is walked without
  // recursion; nesting is bounded by the parser.
  ResolvedFormula resolve(const Expression& expression) {
    std::vector<const Expression*> open;
    const Expression* part = &expression;
    while (part->kind == Expression::Kind::binary) {
      open.push_back(part);
      part = part->operands[0].get();
    }
    ResolvedFormula result = operand(*part);
    for (; !open.empty(); open.pop_back()) {
      const Expression& node = *open.back();
      result = binary(node, std::move(result), resolve(*node.operands[1]));
    }
    return result;
  }

  ResolvedFormula operand(const Expression& expression) {
    switch (expression.kind) {
      case Expression::Kind::number:
        return {robot::constant_formula(expression.number.value),
                script_check::kind_of_unit(expression.number.unit)};
      case Expression::Kind::parameter: {
        std::optional<ResolvedFormula> named = names_.resolve(expression.name, diagnostics_);
        if (named) return *std::move(named);
        failed_ = true;
        return {};
      }
      case Expression::Kind::call:
        return call(expression);
      case Expression::Kind::negate: {
        ResolvedFormula value = resolve(*expression.operands[0]);
        append(value.formula, operation(FormulaOp::Kind::negate), expression.span);
        return value;
      }
      case Expression::Kind::plus:
        return resolve(*expression.operands[0]);
      case Expression::Kind::variable:
        return refuse(expression.span, "variables belong to behaviours and cannot stand here");
      case Expression::Kind::command:
        return refuse(expression.span,
                      fmt::format("'{}' is a command, not a value", expression.name.text()));
      case Expression::Kind::logical_not:
      case Expression::Kind::binary:
        break;
    }
    return refuse_condition(expression);
  }

  ResolvedFormula call(const Expression& expression) {
    const std::string name = expression.name.text();
    if (name != "sin" && name != "cos") {
      const std::string nearest = did_you_mean(name, {"sin", "cos"});
      return refuse(expression.span,
                    fmt::format("function '{}' cannot stand here{}; sums, products, negation, sin "
                                "and cos can",
                                name, nearest.empty() ? "" : " (did you mean " + nearest + "?)"));
    }
    if (expression.operands.size() != 1) {
      failed_ = true;
      diagnostics_.error(
          "F06", expression.span,
          fmt::format("{} takes 1 argument, found {}", name, expression.operands.size()));
      return {};
    }
    ResolvedFormula value = resolve(*expression.operands[0]);
    if (const Expression* misfit =
            script_check::misfit_literal(*expression.operands[0], ValueKind::angle)) {
      check_literal(*misfit, ValueKind::angle, name + "(...)");
    } else if (!script_check::fits(value.kind, ValueKind::angle)) {
      diagnostics_.warning("F13", expression.operands[0]->span,
                           fmt::format("{} needs an angle, but the value is {}", name,
                                       script_check::kind_text(value.kind)));
    }
    const auto kind = name == "sin" ? FormulaOp::Kind::sin : FormulaOp::Kind::cos;
    append(value.formula, operation(kind), expression.span);
    return {std::move(value.formula), ValueKind::number};
  }

  ResolvedFormula binary(const Expression& node, ResolvedFormula left, ResolvedFormula right) {
    using Operator = Expression::Operator;
    ResolvedFormula result;
    FormulaOp::Kind kind = FormulaOp::Kind::add;
    switch (node.op) {
      case Operator::add:
      case Operator::subtract:
        kind = node.op == Operator::add ? FormulaOp::Kind::add : FormulaOp::Kind::subtract;
        result.kind = script_check::sum_kind(left.kind, right.kind);
        if (mixed(left.kind, right.kind)) report_mixed(node, left.kind, right.kind);
        break;
      case Operator::multiply:
        kind = FormulaOp::Kind::multiply;
        result.kind = scaled(left, right) ? ValueKind::unknown
                                          : script_check::product_kind(left.kind, right.kind);
        break;
      case Operator::divide: {
        kind = FormulaOp::Kind::divide;
        result.kind = scaled(left, right) ? ValueKind::unknown
                                          : script_check::quotient_kind(left.kind, right.kind);
        const std::optional<double> divisor = folded_value(right.formula);
        if (!divisor && !right.formula.code.empty()) {
          return refuse(node.op_span, "only a constant can be divided by");
        }
        if (divisor == 0.0) {
          failed_ = true;
          diagnostics_.error("F11", node.op_span, "division by zero");
          return {};
        }
        break;
      }
      default:
        return refuse_condition(node);
    }
    result.formula = std::move(left.formula);
    const bool foldable =
        folded_value(result.formula).has_value() && folded_value(right.formula).has_value();
    result.formula.code.insert(result.formula.code.end(), right.formula.code.begin(),
                               right.formula.code.end());
    result.formula.code.push_back(operation(kind));
    if (foldable) fold(result.formula, node.op_span);
    return result;
  }

  /// A bare factor may turn one kind into another: `z <- z + 0.01 * theta_s`.
  static bool scaled(const ResolvedFormula& left, const ResolvedFormula& right) {
    return (left.kind == ValueKind::number && folded_value(left.formula)) ||
           (right.kind == ValueKind::number && folded_value(right.formula));
  }

  static bool mixed(ValueKind a, ValueKind b) {
    return a != b && a != ValueKind::number && b != ValueKind::number && a != ValueKind::unknown &&
           b != ValueKind::unknown;
  }

  /// A literal of the wrong kind is an error, all else may be meant.
  void report_mixed(const Expression& node, ValueKind left, ValueKind right) {
    for (const bool second : {true, false}) {
      const Expression& operand = *node.operands[second ? 1 : 0];
      if (operand.kind != Expression::Kind::number) continue;
      failed_ = true;
      diagnostics_.error("F09", operand.span,
                         fmt::format("'{}' is {} and stands beside {}", operand.number.unit_text,
                                     script_check::kind_text(second ? right : left),
                                     script_check::kind_text(second ? left : right)));
      return;
    }
    diagnostics_.warning(
        "F13", node.op_span,
        fmt::format("{} {} and {}", node.op == Expression::Operator::add ? "adds" : "subtracts",
                    script_check::kind_text(left), script_check::kind_text(right)));
  }

  void append(Formula& formula, FormulaOp op, Span span) {
    const bool foldable = folded_value(formula).has_value();
    formula.code.push_back(op);
    if (foldable) fold(formula, span);
  }

  void fold(Formula& formula, Span span) {
    const double value = formula.evaluate({});
    if (!std::isfinite(value)) {
      failed_ = true;
      diagnostics_.error("F11", span, "the value is too large to be computed");
      return;
    }
    formula = robot::constant_formula(value);
  }

  void check_literal(const Expression& literal, ValueKind wanted, const std::string& what) {
    failed_ = true;
    diagnostics_.error(
        "F09", literal.span,
        fmt::format("{} needs {}, but '{}' is {}", what, script_check::kind_text(wanted),
                    literal.number.unit_text,
                    script_check::kind_text(script_check::kind_of_unit(literal.number.unit))));
  }

  ResolvedFormula refuse(Span span, std::string message) {
    failed_ = true;
    diagnostics_.error("F10", span, std::move(message));
    return {};
  }

  ResolvedFormula refuse_condition(const Expression& expression) {
    return refuse(expression.op_span.file == kNoFile ? expression.span : expression.op_span,
                  "conditions cannot stand here; sums, products, negation, sin and cos can");
  }

  FormulaNames& names_;
  Diagnostics& diagnostics_;
  bool failed_ = false;
};

}  // namespace

std::optional<math::Pose> FormulaNames::place_of(const syntax::QualifiedName& node,
                                                 Diagnostics& diagnostics) {
  diagnostics.error("F12", node.span, "the place of a node stands in plans only");
  return std::nullopt;
}

std::optional<ResolvedFormula> NoFormulaNames::resolve(const syntax::QualifiedName& name,
                                                       Diagnostics& diagnostics) {
  diagnostics.error(
      "F12", name.span,
      fmt::format("the frames of a plan are constant: '{}' cannot stand here", name.text()));
  return std::nullopt;
}

std::optional<ResolvedFormula> resolve_formula(const Expression& expression, FormulaNames& names,
                                               Diagnostics& diagnostics) {
  return FormulaResolver(names, diagnostics).run(expression);
}

std::optional<ResolvedFormula> resolve_formula(const Expression& expression, ValueKind wanted,
                                               std::string_view what, FormulaNames& names,
                                               Diagnostics& diagnostics) {
  std::optional<ResolvedFormula> result = resolve_formula(expression, names, diagnostics);
  if (!result) return result;
  if (const Expression* misfit = script_check::misfit_literal(expression, wanted)) {
    diagnostics.error(
        "F09", misfit->span,
        fmt::format("{} needs {}, but '{}' is {}", what, script_check::kind_text(wanted),
                    misfit->number.unit_text,
                    script_check::kind_text(script_check::kind_of_unit(misfit->number.unit))));
    return std::nullopt;
  }
  if (!script_check::fits(result->kind, wanted)) {
    diagnostics.warning(
        "F13", expression.span,
        fmt::format("{} needs {}, but the value is {}", what, script_check::kind_text(wanted),
                    script_check::kind_text(result->kind)));
  }
  return result;
}

std::optional<double> folded_value(const Formula& formula) {
  if (formula.code.size() != 1 || formula.code[0].kind != FormulaOp::Kind::constant) {
    return std::nullopt;
  }
  return formula.code[0].value;
}

}  // namespace rubicon::interpreter
