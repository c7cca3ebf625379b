#pragma once

#include <utility>
#include <vector>

#include "grammar/expression.hpp"
#include "interpreter/parse/parse_control.hpp"

/// Actions of the tokens and of expressions. Only for the parse_*.cpp files.
namespace rubicon::interpreter {

/// Operators of one expression, so that its tree stays shallow enough to walk by recursion.
inline constexpr int kMaxOperators = 1000;

/// Expressions under construction, on a stack of operands and one of operators.
class ExpressionState : public ParseState {
 public:
  using ParseState::ParseState;

  struct Checkpoint : ParseState::Checkpoint {
    std::size_t operands = 0;
    std::size_t operators = 0;
    std::size_t calls = 0;
  };
  Checkpoint checkpoint() const {
    return {ParseState::checkpoint(), operands_.size(), operators_.size(), calls_.size()};
  }
  void roll_back(const Checkpoint& checkpoint);

  void push_number(const char* from);
  void push_name(syntax::Expression::Kind kind, const char* from);
  void push_command(const char* from);
  void open_call() { calls_.push_back(operands_.size()); }
  void close_call(const char* end);
  void close_group(const char* from);
  void push_operator(syntax::Expression::Operator op, const char* from);
  void apply_sign(syntax::Expression::Kind kind, const char* from, std::size_t sign_length);
  void apply_operator();
  /// The finished expression.
  syntax::ExpressionPtr take_expression();
  /// The same inside of another expression, or of a name.
  syntax::ExpressionPtr take_operand();
  /// The indices of a name end.
  void close_name();
  /// A finished expression as a number: a literal with its sign, or what is to be computed.
  syntax::Number take_quantity();

 private:
  struct Operand {
    syntax::ExpressionPtr expression;
    const char* begin;  ///< with the parentheses around it
    const char* end;
  };
  std::vector<Operand> operands_;
  std::vector<std::pair<syntax::Expression::Operator, Span>> operators_;
  std::vector<std::size_t> calls_;
  int operator_count_ = 0;
};

template <typename Rule>
struct ExpressionAction : tao::pegtl::nothing<Rule> {};

// NOLINTBEGIN(bugprone-macro-parentheses): names of types
#define RUBICON_ACTION(Action, State, Rule)                                  \
  template <>                                                                \
  struct Action<grammar::Rule> {                                             \
    template <typename ActionInput>                                          \
    static void apply([[maybe_unused]] const ActionInput& in, State& st) {   \
      act(in.begin(), in.end(), st);                                         \
    }                                                                        \
    static void act(const char* begin, const char* end, State& st);          \
  };                                                                         \
  inline void Action<grammar::Rule>::act([[maybe_unused]] const char* begin, \
                                         [[maybe_unused]] const char* end, State& st)
// NOLINTEND(bugprone-macro-parentheses)

// tokens
RUBICON_ACTION(ExpressionAction, ParseState, end_of_token) { st.last_end = begin; }
RUBICON_ACTION(ExpressionAction, ParseState, name_text) { st.set_name(begin, end); }
RUBICON_ACTION(ExpressionAction, ParseState, dot) { st.set_dot(); }
RUBICON_ACTION(ExpressionAction, ParseState, number_text) { st.set_number(begin, end); }
RUBICON_ACTION(ExpressionAction, ParseState, unit_text) { st.set_unit(begin, end); }
RUBICON_ACTION(ExpressionAction, ParseState, unknown_unit) { st.unknown_unit(begin, end); }
RUBICON_ACTION(ExpressionAction, ParseState, negative_number) {
  st.number.value = -st.number.value;
  st.number.span.begin = st.span(begin, end).begin;
}
RUBICON_ACTION(ExpressionAction, ParseState, string_open) { st.string_begin = begin; }
RUBICON_ACTION(ExpressionAction, ParseState, string_content) {
  st.string.text.assign(begin, end);
  st.string.span = st.span(st.string_begin, end + 1);
}
RUBICON_ACTION(ExpressionAction, ParseState, unterminated_string) {
  st.string.span = st.span(st.string_begin, end);
  st.report("S04", st.string_begin, end, "this text is never closed: '\"' is missing on its line");
}
RUBICON_ACTION(ExpressionAction, ParseState, unterminated_comment) {
  st.report("S04", begin, begin + 2, "this comment is never closed: '*/' is missing");
}

// indices of names
RUBICON_ACTION(ExpressionAction, ParseState, index_open) { st.open_indices(); }
RUBICON_ACTION(ExpressionAction, ExpressionState, index_value) { st.add_index(st.take_operand()); }
RUBICON_ACTION(ExpressionAction, ExpressionState, index_close) { st.close_name(); }

// operands
RUBICON_ACTION(ExpressionAction, ExpressionState, number_operand) { st.push_number(begin); }
RUBICON_ACTION(ExpressionAction, ExpressionState, operand_name) {
  st.push_name(syntax::Expression::Kind::parameter, begin);
}
RUBICON_ACTION(ExpressionAction, ExpressionState, command_operand_word) { st.push_command(begin); }
RUBICON_ACTION(ExpressionAction, ExpressionState, variable_operand) {
  st.push_name(syntax::Expression::Kind::variable, begin);
}
RUBICON_ACTION(ExpressionAction, ExpressionState, call_open) { st.open_call(); }
RUBICON_ACTION(ExpressionAction, ExpressionState, call) { st.close_call(st.last_end); }
RUBICON_ACTION(ExpressionAction, ExpressionState, group) { st.close_group(begin); }

// operators
#define RUBICON_OPERATOR(Rule, op)                             \
  RUBICON_ACTION(ExpressionAction, ExpressionState, Rule) {    \
    st.push_operator(syntax::Expression::Operator::op, begin); \
  }
RUBICON_OPERATOR(multiply_operator, multiply)
RUBICON_OPERATOR(divide_operator, divide)
RUBICON_OPERATOR(add_operator, add)
RUBICON_OPERATOR(subtract_operator, subtract)
RUBICON_OPERATOR(equal_operator, equal)
RUBICON_OPERATOR(not_equal_operator, not_equal)
RUBICON_OPERATOR(less_equal_operator, less_equal)
RUBICON_OPERATOR(greater_equal_operator, greater_equal)
RUBICON_OPERATOR(less_operator, less)
RUBICON_OPERATOR(greater_operator, greater)
RUBICON_OPERATOR(and_operator, logical_and)
RUBICON_OPERATOR(or_operator, logical_or)
#undef RUBICON_OPERATOR

RUBICON_ACTION(ExpressionAction, ExpressionState, product_tail) { st.apply_operator(); }
RUBICON_ACTION(ExpressionAction, ExpressionState, sum_tail) { st.apply_operator(); }
RUBICON_ACTION(ExpressionAction, ExpressionState, comparison_tail) { st.apply_operator(); }
RUBICON_ACTION(ExpressionAction, ExpressionState, and_tail) { st.apply_operator(); }
RUBICON_ACTION(ExpressionAction, ExpressionState, or_tail) { st.apply_operator(); }
RUBICON_ACTION(ExpressionAction, ExpressionState, negation) {
  st.apply_sign(syntax::Expression::Kind::negate, begin, 1);
}
RUBICON_ACTION(ExpressionAction, ExpressionState, affirmation) {
  st.apply_sign(syntax::Expression::Kind::plus, begin, 1);
}
RUBICON_ACTION(ExpressionAction, ExpressionState, inversion) {
  st.apply_sign(syntax::Expression::Kind::logical_not, begin, 3);
}

}  // namespace rubicon::interpreter
