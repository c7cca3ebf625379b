#include "interpreter/check/resolve_keep.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace rubicon::interpreter {

namespace {

using syntax::Expression;
using Operator = Expression::Operator;

/// Depth of a condition; parsers allow 200.
constexpr int kMostDepth = 200;

/// A sum of multiples of parameters and a number.
struct Sum {
  std::map<int, double> factors;
  double number = 0;

  void add(const Sum& other, double factor) {
    for (const auto& [index, each] : other.factors) factors[index] += factor * each;
    number += factor * other.number;
  }
  void scale(double factor) {
    for (auto& [index, each] : factors) each *= factor;
    number *= factor;
  }
};

class KeepResolver {
 public:
  KeepResolver(const robot::RobotModel& robot, std::vector<guides::KeptBound>& bounds,
               Diagnostics& diagnostics)
      : robot_(robot), bounds_(bounds), diagnostics_(diagnostics) {}

  void resolve(const Expression& condition, int depth = 0) {
    const bool is_binary = condition.kind == Expression::Kind::binary && depth < kMostDepth;
    if (is_binary && condition.op == Operator::logical_and) {
      resolve(*condition.operands[0], depth + 1);
      resolve(*condition.operands[1], depth + 1);
      return;
    }
    const bool at_most =
        is_binary && (condition.op == Operator::less_equal || condition.op == Operator::less);
    const bool at_least =
        is_binary && (condition.op == Operator::greater_equal || condition.op == Operator::greater);
    if (!at_most && !at_least) {
      fail(condition.span);
      return;
    }
    const Expression& small = *condition.operands[at_most ? 0 : 1];
    const Expression& large = *condition.operands[at_most ? 1 : 0];
    if (is_abs(small)) {
      bound(*small.operands[0], large, 1);
      bound(*small.operands[0], large, -1);
    } else {
      bound(small, large, 1);
    }
  }

 private:
  static bool is_abs(const Expression& expression) {
    return expression.kind == Expression::Kind::call && expression.name.text() == "abs" &&
           expression.operands.size() == 1;
  }

  /// sign * small <= large
  void bound(const Expression& small, const Expression& large, double sign) {
    std::optional<Sum> left = sum(small, 0);
    if (!left) return;
    const std::optional<Sum> right = sum(large, 0);
    if (!right) return;
    left->scale(sign);
    left->add(*right, -1);
    guides::KeptBound kept;
    for (const auto& [index, factor] : left->factors) {
      if (factor != 0) kept.terms.emplace_back(index, factor);
    }
    kept.most = -left->number;
    bounds_.push_back(std::move(kept));
  }

  std::optional<Sum> sum(const Expression& expression, int depth) {
    if (depth > kMostDepth) return fail(expression.span);
    switch (expression.kind) {
      case Expression::Kind::number:
        return Sum{{}, expression.number.value};
      case Expression::Kind::parameter:
        return parameter(expression);
      case Expression::Kind::negate:
      case Expression::Kind::plus: {
        std::optional<Sum> value = sum(*expression.operands[0], depth + 1);
        if (value && expression.kind == Expression::Kind::negate) value->scale(-1);
        return value;
      }
      case Expression::Kind::binary:
        return combined(expression, depth);
      default:
        return fail(expression.span);
    }
  }

  std::optional<Sum> combined(const Expression& expression, int depth) {
    std::optional<Sum> left = sum(*expression.operands[0], depth + 1);
    if (!left) return left;
    std::optional<Sum> right = sum(*expression.operands[1], depth + 1);
    if (!right) return right;
    switch (expression.op) {
      case Operator::add:
      case Operator::subtract:
        left->add(*right, expression.op == Operator::add ? 1 : -1);
        return left;
      case Operator::multiply:
        if (!left->factors.empty()) std::swap(left, right);
        if (!left->factors.empty()) return fail(expression.span);
        right->scale(left->number);
        return right;
      case Operator::divide:
        if (!right->factors.empty() || right->number == 0) return fail(expression.span);
        left->scale(1 / right->number);
        return left;
      default:
        return fail(expression.span);
    }
  }

  std::optional<Sum> parameter(const Expression& expression) {
    const int index = resolve_parameter(robot_, -1, expression.name);
    if (index < 0) {
      diagnostics_.error(
          "G03", expression.span,
          fmt::format("'{}' is {} of robot '{}'", expression.name.text(),
                      index == -2 ? "a parameter of several bodies" : "no parameter", robot_.name));
      return std::nullopt;
    }
    const robot::Parameter& p = robot_.parameters[static_cast<std::size_t>(index)];
    if (p.cyclic || p.derived) {
      diagnostics_.error(
          "G03", expression.span,
          fmt::format("keep is about parameters that have a range; '{}' {}", p.display_name,
                      p.derived ? "is derived from others" : "turns freely"));
      return std::nullopt;
    }
    return Sum{{{index, 1.0}}, 0};
  }

  std::optional<Sum> fail(Span span) {
    diagnostics_.error("G03", span,
                       "keep takes comparisons by <= and >= of sums of parameters, joined by and",
                       "for example keep (abs(boom.phi + stick.phi) <= 90 and boom.phi >= 10);");
    return std::nullopt;
  }

  const robot::RobotModel& robot_;
  std::vector<guides::KeptBound>& bounds_;
  Diagnostics& diagnostics_;
};

}  // namespace

void resolve_keep(const Expression& condition, const robot::RobotModel& robot,
                  std::vector<guides::KeptBound>& bounds, Diagnostics& diagnostics) {
  KeepResolver(robot, bounds, diagnostics).resolve(condition);
}

}  // namespace rubicon::interpreter
