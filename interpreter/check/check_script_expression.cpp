#include "interpreter/check/check_script_expression.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "interpreter/syntax/unparse.hpp"

namespace rubicon::interpreter::script_check {

namespace {

using syntax::Expression;
using ExpressionKind = Expression::Kind;
using Operator = Expression::Operator;

// Longer values say nothing in a message, and a deep one would cost stack.
constexpr std::size_t kLongestShownText = 60;
constexpr int kDeepestShownNesting = 12;

double metres_degrees_seconds_per(const std::string& unit) {
  static constexpr std::pair<const char*, double> kUnits[] = {
      {"mm", 1e-3},          {"cm", 1e-2},    {"rad", 180 / 3.14159265358979323846},
      {"min", 60},           {"h", 3600},     {"t", 1000},
      {"mm/s", 1e-3},        {"mm/s2", 1e-3}, {"rpm", 6},
      {"per h", 1 / 3600.0},
  };
  for (const auto& [name, factor] : kUnits) {
    if (unit == name) return factor;
  }
  return 1;
}

int precedence(const Expression& expression) {
  switch (expression.kind) {
    case ExpressionKind::logical_not:
      return 3;
    case ExpressionKind::negate:
    case ExpressionKind::plus:
      return 7;
    case ExpressionKind::binary:
      break;
    default:
      return 8;
  }
  switch (expression.op) {
    case Operator::logical_or:
      return 1;
    case Operator::logical_and:
      return 2;
    case Operator::add:
    case Operator::subtract:
      return 5;
    case Operator::multiply:
    case Operator::divide:
      return 6;
    default:
      return 4;
  }
}

std::optional<std::string> text_of(const Expression& expression, int depth);

std::optional<std::string> operand_text(const Expression& operand, int least, int depth) {
  std::optional<std::string> text = text_of(operand, depth);
  if (text && precedence(operand) < least) return "(" + *text + ")";
  return text;
}

// The text of a short expression; nothing where it is too long or too deep to be worth showing.
std::optional<std::string> text_of(const Expression& expression, int depth) {
  if (depth > kDeepestShownNesting) return std::nullopt;
  const auto operand = [&](std::size_t i, int least) {
    return operand_text(*expression.operands[i], least, depth + 1);
  };
  std::optional<std::string> text;
  switch (expression.kind) {
    case ExpressionKind::number:
      text = number_text(expression.number);
      break;
    case ExpressionKind::parameter:
      text = expression.name.text();
      break;
    case ExpressionKind::variable:
      text = "var(" + expression.name.text() + ")";
      break;
    case ExpressionKind::call:
    case ExpressionKind::command: {
      std::string call = expression.name.text() + "(";
      for (std::size_t i = 0; i < expression.operands.size(); ++i) {
        const std::optional<std::string> argument = operand(i, 0);
        if (!argument) return std::nullopt;
        call += (i > 0 ? ", " : "") + *argument;
      }
      text = call + ")";
      break;
    }
    case ExpressionKind::negate:
    case ExpressionKind::plus:
      text = operand(0, 7);
      if (text) text = (expression.kind == ExpressionKind::negate ? "-" : "+") + *text;
      break;
    case ExpressionKind::logical_not:
      text = operand(0, 3);
      if (text) text = "not " + *text;
      break;
    case ExpressionKind::binary: {
      const int own = precedence(expression);
      const std::optional<std::string> left = operand(0, own);
      const std::optional<std::string> right = operand(1, own + 1);
      if (left && right) text = fmt::format("{} {} {}", *left, symbol_of(expression.op), *right);
      break;
    }
  }
  if (text && text->size() > kLongestShownText) return std::nullopt;
  return text;
}

}  // namespace

void for_each_subexpression(const Expression& expression,
                            const std::function<void(const Expression&)>& visit) {
  std::vector<const Expression*> open{&expression};
  while (!open.empty()) {
    const Expression* next = open.back();
    open.pop_back();
    visit(*next);
    for (std::size_t i = next->operands.size(); i > 0; --i) {
      if (next->operands[i - 1]) open.push_back(next->operands[i - 1].get());
    }
  }
}

bool same_expression(const Expression& a, const Expression& b, const SameName& same_parameter) {
  std::vector<std::pair<const Expression*, const Expression*>> open{{&a, &b}};
  while (!open.empty()) {
    const auto [left, right] = open.back();
    open.pop_back();
    if (left->kind != right->kind || left->operands.size() != right->operands.size()) return false;
    switch (left->kind) {
      case ExpressionKind::number:
        if (left->number.value != right->number.value) return false;
        break;
      case ExpressionKind::parameter:
        if (!same_parameter(left->name, right->name)) return false;
        break;
      case ExpressionKind::variable:
      case ExpressionKind::call:
      case ExpressionKind::command:
        if (left->name.text() != right->name.text()) return false;
        break;
      case ExpressionKind::binary:
        if (left->op != right->op) return false;
        break;
      default:
        break;
    }
    for (std::size_t i = 0; i < left->operands.size(); ++i) {
      open.emplace_back(left->operands[i].get(), right->operands[i].get());
    }
  }
  return true;
}

std::string number_text(const syntax::Number& number) {
  const double written = number.value / metres_degrees_seconds_per(number.unit_text);
  // Ten digits hide the rounding of the conversion to base units and back.
  const std::string digits = fmt::format("{:.10g}", written);
  return number.unit_text.empty() ? digits : digits + " " + number.unit_text;
}

std::string command_text(const syntax::Statement& command) {
  std::optional<std::string> value;
  if (command.value) value = text_of(*command.value, 0);
  return fmt::format("{}({}, {})",
                     command.kind == syntax::Statement::Kind::move_dir ? "move_dir" : "move_to",
                     command.name.text(), value.value_or("..."));
}

}  // namespace rubicon::interpreter::script_check
