#include "interpreter/parse/parse_expression.hpp"

#include <fmt/format.h>

namespace rubicon::interpreter {

using syntax::Expression;

void ExpressionState::roll_back(const Checkpoint& checkpoint) {
  ParseState::roll_back(checkpoint);
  operands_.resize(checkpoint.operands);
  operators_.resize(checkpoint.operators);
  calls_.resize(checkpoint.calls);
  operator_count_ = 0;
}

void ExpressionState::push_number(const char* from) {
  auto expression = std::make_unique<Expression>();
  expression->kind = Expression::Kind::number;
  expression->number = number;
  expression->span = number.span;
  operands_.push_back({std::move(expression), from, last_end});
}

void ExpressionState::push_name(Expression::Kind kind, const char* from) {
  auto expression = std::make_unique<Expression>();
  expression->kind = kind;
  expression->name = take_qualified_name();
  expression->span = span_from(from);
  operands_.push_back({std::move(expression), from, last_end});
}

void ExpressionState::push_command(const char* from) {
  auto expression = std::make_unique<Expression>();
  expression->kind = Expression::Kind::command;
  expression->span = span_from(from);
  expression->name.name = {std::string(from, last_end), expression->span};
  expression->name.span = expression->span;
  operands_.push_back({std::move(expression), from, last_end});
}

void ExpressionState::close_call(const char* end) {
  const std::size_t first = calls_.back();
  calls_.pop_back();
  Operand& callee = operands_[first - 1];
  if (callee.expression->kind == Expression::Kind::parameter) {
    callee.expression->kind = Expression::Kind::call;
  }
  for (std::size_t i = first; i < operands_.size(); ++i) {
    callee.expression->operands.push_back(std::move(operands_[i].expression));
  }
  callee.end = end;
  callee.expression->span = span(callee.begin, end);
  operands_.resize(first);
}

void ExpressionState::close_group(const char* from) {
  operands_.back().begin = from;
  operands_.back().end = last_end;
}

void ExpressionState::push_operator(Expression::Operator op, const char* from) {
  operators_.emplace_back(op, span_from(from));
  if (++operator_count_ > kMaxOperators) {
    report_token(
        "S04", from,
        fmt::format("more than {} operators in one expression: set a variable for parts of it",
                    kMaxOperators));
    throw ParseFailure{from};
  }
}

void ExpressionState::apply_sign(Expression::Kind kind, const char* from, std::size_t sign_length) {
  Operand& operand = operands_.back();
  auto expression = std::make_unique<Expression>();
  expression->kind = kind;
  expression->op_span = span(from, from + sign_length);
  expression->span = span(from, operand.end);
  expression->operands.push_back(std::move(operand.expression));
  operand.expression = std::move(expression);
  operand.begin = from;
}

void ExpressionState::apply_operator() {
  Operand right = std::move(operands_.back());
  operands_.pop_back();
  Operand& left = operands_.back();
  auto expression = std::make_unique<Expression>();
  expression->kind = Expression::Kind::binary;
  expression->op = operators_.back().first;
  expression->op_span = operators_.back().second;
  operators_.pop_back();
  expression->span = span(left.begin, right.end);
  expression->operands.push_back(std::move(left.expression));
  expression->operands.push_back(std::move(right.expression));
  left.expression = std::move(expression);
  left.end = right.end;
}

syntax::ExpressionPtr ExpressionState::take_expression() {
  operator_count_ = 0;
  return take_operand();
}

syntax::ExpressionPtr ExpressionState::take_operand() {
  syntax::ExpressionPtr result = std::move(operands_.back().expression);
  operands_.pop_back();
  return result;
}

// Operators in the brackets of an operand count with those around, so that trees stay shallow.
void ExpressionState::close_name() {
  close_indices();
  if (!has_open_indices() && operands_.empty()) operator_count_ = 0;
}

syntax::Number ExpressionState::take_quantity() {
  syntax::ExpressionPtr whole = take_expression();
  const Expression* literal = whole.get();
  const bool signed_once =
      literal->kind == Expression::Kind::negate || literal->kind == Expression::Kind::plus;
  if (signed_once) literal = literal->operands[0].get();
  if (literal->kind != Expression::Kind::number) {
    syntax::Number computed;
    computed.span = whole->span;
    computed.expression = std::move(whole);
    return computed;
  }
  syntax::Number result = literal->number;
  if (whole->kind == Expression::Kind::negate) {
    result.value = -result.value;
    result.span.begin = whole->span.begin;
  }
  return result;
}

}  // namespace rubicon::interpreter
