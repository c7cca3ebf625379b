#include <fmt/format.h>

#include <array>
#include <limits>
#include <set>
#include <utility>

#include "interpreter/check/check_script_expression.hpp"
#include "interpreter/check/check_script_needs.hpp"
#include "interpreter/check/check_script_parameters.hpp"
#include "interpreter/check/check_script_parts.hpp"
#include "interpreter/check/check_script_values.hpp"
#include "interpreter/functions/function_table.hpp"
#include "interpreter/syntax/unparse.hpp"

namespace rubicon::interpreter::script_check {

namespace {

using syntax::Expression;
using syntax::Statement;
using Operator = Expression::Operator;
using VariableKinds = std::map<std::string, ValueKind>;

/// The numbers of arguments that functions of this name take, in words.
std::string counts_text(const std::string& name) {
  std::string text;
  std::size_t last = 0;
  for (const Function& function : functions()) {
    if (function.name != name) continue;
    last = function.argument_count();
    text += (text.empty() ? "" : " or ") + std::to_string(last);
  }
  return text == "0" ? "no arguments" : text + (last == 1 ? " argument" : " arguments");
}

/// The kind of value that an argument needs where the function names no parameter.
ValueKind wanted_kind(Argument argument) {
  return argument == Argument::angle   ? ValueKind::angle
         : argument == Argument::place ? ValueKind::place
                                       : ValueKind::unknown;
}

/// `like`: the kind of the parameter, or of the argument.
ValueKind result_kind(Result result, ValueKind like) {
  switch (result) {
    case Result::of_parameter:
      return like;
    case Result::of_argument:
      return like == ValueKind::direction ? ValueKind::number : like;
    case Result::direction:
      return ValueKind::direction;
    case Result::condition:
      return ValueKind::condition;
    case Result::number:
      return ValueKind::number;
    case Result::length:
      return ValueKind::length;
    case Result::time:
      return ValueKind::time;
    case Result::place:
      return ValueKind::place;
  }
  return ValueKind::unknown;
}

/// Gives every expression its kind, text order, and says what does not fit.
class KindChecker {
 public:
  /// `whole_script`: the kinds of the variables over all their assignments, where they are known
  /// already.
  KindChecker(const Subject& subject, Diagnostics& diagnostics, const VariableKinds& whole_script)
      : subject_(subject),
        diagnostics_(diagnostics),
        whole_script_(whole_script),
        names_(subject, diagnostics),
        needs_(diagnostics) {}

  VariableKinds run() {
    // Definitions and the main sequence are kept apart; text order decides what is known of a
    // variable.
    const auto& behaviours = subject_.script.behaviours;
    const auto& main = subject_.script.statements;
    std::size_t i = 0, j = 0;
    while (i < behaviours.size() || j < main.size()) {
      const bool behaviour_next =
          j == main.size() ||
          (i < behaviours.size() && behaviours[i].span.begin < main[j].span.begin);
      if (behaviour_next) {
        in_behaviour_ = true;
        for (const Statement& statement : behaviours[i].statements) check(statement);
        in_behaviour_ = false;
        ++i;
      } else {
        check(main[j++]);
      }
    }
    return std::move(kinds_);
  }

 private:
  // ---- statements ----

  void check(const Statement& statement) {
    switch (statement.kind) {
      case Statement::Kind::assignment:
        names_.next_statement();
        assign(statement.name.text(), kind_of(*statement.value));
        break;
      case Statement::Kind::move_to:
        check_move_to(statement);
        break;
      case Statement::Kind::move_dir:
        check_move_dir(statement);
        break;
      case Statement::Kind::chain:
      case Statement::Kind::cycle:
      case Statement::Kind::first:
        check_loop(statement);
        break;
      case Statement::Kind::together:
      case Statement::Kind::each:
        for (const Statement& element : statement.elements) check(element);
        break;
      case Statement::Kind::which:
        for (const syntax::Module& module : statement.modules) {
          for (const syntax::Label& label : module.labels) {
            if (label.condition) need_condition("when", *label.condition);
          }
          for (const Statement& part : module.statements) check(part);
        }
        break;
      case Statement::Kind::wait:
      case Statement::Kind::use:
      case Statement::Kind::broken:
        break;
    }
  }

  void assign(const std::string& variable, ValueKind kind) {
    const auto [place, is_new] = kinds_.emplace(variable, kind);
    if (!is_new) place->second = joined(place->second, kind);
  }

  void check_loop(const Statement& loop) {
    // What a loop assigns further down is seen further up the next time round.
    if (loop_depth_++ == 0) {
      std::set<std::string> assigned;
      collect_targets(loop.elements, assigned);
      for (const std::string& variable : assigned) {
        const auto whole = whole_script_.find(variable);
        if (whole != whole_script_.end()) assign(variable, whole->second);
      }
    }
    for (const Statement& element : loop.elements) check(element);
    if (loop.until) need_condition("until", *loop.until);
    --loop_depth_;
  }

  void check_move_to(const Statement& command) {
    names_.next_statement();
    const Parameter parameter = names_.resolve(command.name, command.keyword);
    const bool movable = names_.check_movable(parameter, command.keyword);
    const ValueKind kind = kind_of(*command.value);
    if (!movable) return;
    if (kind == ValueKind::direction) {
      if (parameter.kind == ValueKind::unknown) return;
      diagnostics_.warning("W02", command.keyword,
                           fmt::format("move_to needs a value of {}, but this is a direction; did "
                                       "you mean move_dir?",
                                       command.name.text()));
      return;
    }
    const std::string who = fmt::format("move_to({}, ...)", command.name.text());
    if (!needs_.value(parameter.kind, *command.value, kind, who, command.keyword)) return;
    if (parameter.model == nullptr || parameter.model->direct || parameter.model->rotation) return;
    bool aims_at_goal = false;
    for_each_subexpression(*command.value, [&](const Expression& part) {
      aims_at_goal = aims_at_goal || (part.kind == Expression::Kind::call &&
                                      part.name.text() == "goal" && part.operands.size() == 1 &&
                                      part.operands[0]->kind == Expression::Kind::parameter &&
                                      names_.find(part.operands[0]->name) == parameter.model);
    });
    if (!aims_at_goal) return;
    diagnostics_.warning(
        "W03", command.keyword,
        fmt::format("'{0}' moves along the robot's own axis, so {1} may never arrive; use "
                    "r_goal({0})",
                    command.name.text(), command_text(command)));
  }

  void check_move_dir(const Statement& command) {
    names_.next_statement();
    const Parameter parameter = names_.resolve(command.name, command.keyword);
    const bool movable = names_.check_movable(parameter, command.keyword);
    const ValueKind kind = kind_of(*command.value);
    if (!movable) return;
    needs_.direction(*command.value, kind, "move_dir", command.name.text(), command.keyword,
                     "this command never moves");
  }

  void need_condition(const std::string& who, const Expression& value) {
    names_.next_statement();
    const ValueKind kind = kind_of(value);
    if (kind == ValueKind::condition || kind == ValueKind::unknown) return;
    diagnostics_.error("S12", value.span, who + " needs a condition");
  }

  // ---- expressions ----

  // Long sums lean to the left: they are walked, not recursed into. Other nesting is bounded by the
  // parser.
  ValueKind kind_of(const Expression& expression) {
    std::vector<const Expression*> spine;
    const Expression* at = &expression;
    while (at->kind == Expression::Kind::binary) {
      spine.push_back(at);
      at = at->operands[0].get();
    }
    ValueKind kind = kind_of_operand(*at);
    for (; !spine.empty(); spine.pop_back()) kind = kind_of_binary(*spine.back(), kind);
    return kind;
  }

  ValueKind kind_of_operand(const Expression& expression) {
    switch (expression.kind) {
      case Expression::Kind::number:
        return kind_of_unit(expression.number.unit);
      case Expression::Kind::parameter:
        return names_.resolve(expression.name, expression.span).kind;
      case Expression::Kind::variable:
        return kind_of_variable(expression.name.text());
      case Expression::Kind::call:
        return kind_of_call(expression);
      case Expression::Kind::command:
        diagnostics_.error("S06", expression.name.span,
                           fmt::format("'{}' is a command, not a value", expression.name.text()));
        return ValueKind::unknown;
      case Expression::Kind::negate:
      case Expression::Kind::plus: {
        const ValueKind kind = kind_of(*expression.operands[0]);
        return numbers_only(expression, kind) ? kind : ValueKind::unknown;
      }
      case Expression::Kind::logical_not:
        conditions_only(expression, kind_of(*expression.operands[0]));
        return ValueKind::condition;
      case Expression::Kind::binary:
        break;
    }
    return kind_of(expression);
  }

  ValueKind kind_of_variable(const std::string& name) const {
    // A behaviour may run anywhere, so all assignments count.
    const VariableKinds& kinds = in_behaviour_ ? whole_script_ : kinds_;
    const auto found = kinds.find(name);
    return found == kinds.end() ? ValueKind::unknown : found->second;
  }

  static std::string symbol_of(const Expression& expression) {
    switch (expression.kind) {
      case Expression::Kind::negate:
        return "-";
      case Expression::Kind::plus:
        return "+";
      case Expression::Kind::logical_not:
        return "not";
      default:
        return interpreter::symbol_of(expression.op);
    }
  }

  // The operator's token; of a sign or `not` it begins the expression.
  static Span operator_span(const Expression& expression) {
    return expression.kind == Expression::Kind::binary ? expression.op_span : expression.span;
  }

  bool numbers_only(const Expression& expression, ValueKind kind) {
    if (kind != ValueKind::condition && kind != ValueKind::place) return true;
    diagnostics_.error("S12", operator_span(expression),
                       fmt::format("'{}' needs numbers, not {}", symbol_of(expression),
                                   kind == ValueKind::place ? "places" : "conditions"));
    return false;
  }

  bool conditions_only(const Expression& expression, ValueKind kind) {
    if (kind == ValueKind::condition || kind == ValueKind::unknown) return true;
    diagnostics_.error("S12", operator_span(expression),
                       fmt::format("'{}' needs conditions, not numbers", symbol_of(expression)));
    return false;
  }

  ValueKind kind_of_binary(const Expression& expression, ValueKind left) {
    const ValueKind right = kind_of(*expression.operands[1]);
    switch (expression.op) {
      case Operator::logical_and:
      case Operator::logical_or:
        if (conditions_only(expression, left)) conditions_only(expression, right);
        return ValueKind::condition;
      case Operator::add:
      case Operator::subtract:
        if (!numbers_only(expression, left) || !numbers_only(expression, right)) break;
        if (!same_kind(expression, left, right)) break;
        return sum_kind(left, right);
      case Operator::multiply:
      case Operator::divide:
        if (!numbers_only(expression, left) || !numbers_only(expression, right)) break;
        return expression.op == Operator::multiply ? product_kind(left, right)
                                                   : quotient_kind(left, right);
      default:
        if (numbers_only(expression, left) && numbers_only(expression, right)) {
          same_kind(expression, left, right);
        }
        return ValueKind::condition;
    }
    return ValueKind::unknown;
  }

  // Whether two operands may be added or compared; says so if not.
  bool same_kind(const Expression& expression, ValueKind left, ValueKind right) {
    const bool adds = expression.op == Operator::add;
    const bool sum = adds || expression.op == Operator::subtract;
    // In arithmetic a direction is a plain number; to compare one with a length is a mistake.
    const bool plain = sum && (left == ValueKind::direction || right == ValueKind::direction);
    if (plain || fits(left, right) || fits(right, left)) return true;
    const std::string verb = adds  ? "is added to"
                             : sum ? "stands in a difference with"
                                   : "is compared with";
    if (const Expression* literal = misfit_literal(*expression.operands[1], left)) {
      needs_.wrong_unit(*literal, fmt::format("it {} {}", verb, kind_text(left)));
    } else if (const Expression* other = misfit_literal(*expression.operands[0], right)) {
      needs_.wrong_unit(*other, fmt::format("it {} {}", verb, kind_text(right)));
    } else {
      const std::string message =
          adds  ? fmt::format("adds {} and {}", kind_text(left), kind_text(right))
          : sum ? fmt::format("subtracts {} from {}", kind_text(right), kind_text(left))
                : fmt::format("compares {} and {}", kind_text(left), kind_text(right));
      diagnostics_.warning("W01", expression.op_span, message);
    }
    return false;
  }

  // ---- functions ----

  ValueKind kind_of_call(const Expression& call) {
    const std::string name = call.name.text();
    if (find_function(name) == nullptr) {
      const std::string near = did_you_mean(name, function_names());
      diagnostics_.error("S05", call.span,
                         fmt::format("unknown function '{}'", name) +
                             (near.empty() ? "" : fmt::format("; did you mean {}?", near)));
      return ignore_arguments(call, 0);
    }
    const std::size_t found = call.operands.size();
    const Function* function = find_function(name, found);
    if (function == nullptr) {
      diagnostics_.error("S11", call.span,
                         fmt::format("{} takes {}, found {}", name, counts_text(name), found));
      return ignore_arguments(call, 0);
    }
    if (!function->takes_parameter()) return kind_of_value_call(call, *function);
    if (call.operands[0]->kind != Expression::Kind::parameter) {
      diagnostics_.error("S11", call.span,
                         fmt::format("the first argument of {} must be a control parameter", name));
      return ignore_arguments(call, 0);
    }
    const Parameter parameter = names_.resolve(call.operands[0]->name, call.span);
    return kind_of_parameter_call(call, *function, parameter);
  }

  // Arguments of a call that is wrong itself may hold mistakes of their own.
  ValueKind ignore_arguments(const Expression& call, std::size_t from) {
    for (std::size_t i = from; i < call.operands.size(); ++i) kind_of(*call.operands[i]);
    return ValueKind::unknown;
  }

  ValueKind kind_of_value_call(const Expression& call, const Function& function) {
    const std::string who = fmt::format("{}(...)", function.name);
    ValueKind first = ValueKind::unknown;
    for (std::size_t i = 0; i < call.operands.size(); ++i) {
      const Expression& argument = *call.operands[i];
      const ValueKind kind = kind_of(argument);
      const ValueKind wanted = wanted_kind(function.arguments[i]);
      const bool fits = needs_.value(wanted, argument, kind, who, call.span);
      if (function.arguments[i] != Argument::place && kind == ValueKind::place) {
        diagnostics_.error("S12", argument.span, who + " needs a number, not a place on the way");
        continue;
      }
      if (i == 0 && fits) first = kind;
    }
    if (function.reads == Reads::sensor) check_sensor(call, function);
    return result_kind(function.result, first);
  }

  void check_sensor(const Expression& call, const Function& function) {
    const robot::RobotModel* robot = subject_.context.robot;
    if (robot == nullptr || robot->sensor > 0) return;
    const bool condition = function.result == Result::condition;
    diagnostics_.warning(
        "W09", call.span,
        fmt::format("{} {}: robot '{}' has no sensor; give it a range such as "
                    "'sensor 10;' in the robot file",
                    function.name, condition ? "never holds" : "is always 0", robot->name));
  }

  ValueKind kind_of_parameter_call(const Expression& call, const Function& function,
                                   const Parameter& parameter) {
    const std::string name = call.operands[0]->name.text();
    std::array<ValueKind, kMostArguments> kinds{};
    for (std::size_t i = 1; i < call.operands.size(); ++i) kinds[i] = kind_of(*call.operands[i]);
    if (function.reads == Reads::sensor) check_sensor(call, function);
    const ValueKind result = result_kind(function.result, parameter.kind);
    if (parameter.kind == ValueKind::unknown) return result;
    switch (function.arguments[0]) {
      case Argument::movable_parameter:
        if (!names_.check_movable(parameter, call.span)) return result;
        break;
      case Argument::rotation:
        if (parameter.kind == ValueKind::angle) break;
        diagnostics_.error(
            "S11", call.span,
            fmt::format("{} needs a rotation (psi, phi, theta), not '{}'", function.name, name));
        return ValueKind::unknown;
      case Argument::lower_limited:
      case Argument::upper_limited:
        check_limit(call, function, parameter, name);
        break;
      default:
        break;
    }
    for (std::size_t i = 1; i < call.operands.size(); ++i) {
      const Argument argument = function.arguments[i];
      if (argument == Argument::direction_of_parameter) {
        needs_.direction(*call.operands[i], kinds[i], std::string(function.name), name, call.span,
                         fmt::format("this is never {}", function.name));
      } else {
        const bool alike = argument == Argument::value_of_parameter;
        needs_.value(alike ? parameter.kind : wanted_kind(argument), *call.operands[i], kinds[i],
                     fmt::format("{}({}, ...)", function.name, name), call.span);
      }
    }
    return result;
  }

  void check_limit(const Expression& call, const Function& function, const Parameter& parameter,
                   const std::string& name) {
    if (parameter.model == nullptr) return;
    const bool maximum = function.arguments[0] == Argument::upper_limited;
    const double limit = maximum ? parameter.model->upper : parameter.model->lower;
    const bool limited = !parameter.model->cyclic &&
                         limit != (maximum ? 1 : -1) * std::numeric_limits<double>::infinity();
    if (limited) return;
    const char* why = parameter.model->rotation ? "turns freely" : "has no range";
    diagnostics_.error("S11", call.span,
                       fmt::format("{}({}): '{}' {} and has no {}imum", function.name, name, name,
                                   why, maximum ? "max" : "min"));
  }

  const Subject& subject_;
  Diagnostics& diagnostics_;
  const VariableKinds& whole_script_;
  VariableKinds kinds_;  // of what was assigned so far
  ParameterNames names_;
  ValueNeeds needs_;
  int loop_depth_ = 0;
  bool in_behaviour_ = false;
};

}  // namespace

void check_kinds(const Subject& subject) {
  Diagnostics unheard;
  const VariableKinds none;
  const VariableKinds whole_script = KindChecker(subject, unheard, none).run();
  KindChecker(subject, subject.diagnostics, whole_script).run();
}

}  // namespace rubicon::interpreter::script_check
