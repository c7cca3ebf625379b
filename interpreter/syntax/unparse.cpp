#include "interpreter/syntax/unparse.hpp"

#include <fmt/format.h>

namespace rubicon::interpreter {

using syntax::Expression;
using syntax::Statement;

const char* symbol_of(Expression::Operator op) {
  using Operator = Expression::Operator;
  switch (op) {
    case Operator::add:
      return "+";
    case Operator::subtract:
      return "-";
    case Operator::multiply:
      return "*";
    case Operator::divide:
      return "/";
    case Operator::equal:
      return "==";
    case Operator::not_equal:
      return "!=";
    case Operator::less:
      return "<";
    case Operator::less_equal:
      return "<=";
    case Operator::greater:
      return ">";
    case Operator::greater_equal:
      return ">=";
    case Operator::logical_and:
      return "and";
    case Operator::logical_or:
      return "or";
  }
  return "?";
}

std::string unparse(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::number:
      return fmt::format("{}", expression.number.value);
    case Expression::Kind::parameter:
      return expression.name.text();
    case Expression::Kind::variable:
      return "var(" + expression.name.text() + ")";
    case Expression::Kind::call:
    case Expression::Kind::command: {
      std::string text = expression.name.text() + "(";
      for (std::size_t i = 0; i < expression.operands.size(); ++i) {
        if (i > 0) text += ", ";
        text += unparse(*expression.operands[i]);
      }
      return text + ")";
    }
    case Expression::Kind::negate:
      return "-" + unparse(*expression.operands[0]);
    case Expression::Kind::plus:
      return "+" + unparse(*expression.operands[0]);
    case Expression::Kind::logical_not:
      return "not " + unparse(*expression.operands[0]);
    case Expression::Kind::binary:
      return "(" + unparse(*expression.operands[0]) + " " + symbol_of(expression.op) + " " +
             unparse(*expression.operands[1]) + ")";
  }
  return "";
}

std::string unparse(const Statement& command) {
  switch (command.kind) {
    case Statement::Kind::move_to:
      return "move_to(" + command.name.text() + ", " + unparse(*command.value) + ")";
    case Statement::Kind::move_dir:
      return "move_dir(" + command.name.text() + ", " + unparse(*command.value) + ")";
    case Statement::Kind::together: {
      std::string text = "together { ";
      for (std::size_t i = 0; i < command.elements.size(); ++i) {
        if (i > 0) text += ", ";
        text += unparse(command.elements[i]);
      }
      return text + " }";
    }
    case Statement::Kind::wait:
      return "wait";
    default:
      return "";
  }
}

}  // namespace rubicon::interpreter
