#include <fmt/format.h>

#include <array>
#include <cmath>

#include "interpreter/functions/function_table.hpp"
#include "interpreter/machine/machine.hpp"
#include "interpreter/machine/run_time_error.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter {

namespace {

using OpKind = ExpressionOp::Kind;

double truth(bool holds) { return holds ? 1.0 : 0.0; }

}  // namespace

/// The motion as its functions see it.
class Machine::Scope final : public FunctionScope {
 public:
  Scope(Machine& machine, const World& world) : machine_(machine), world_(world) {}

  const robot::RobotModel& model() const override { return *machine_.model_; }
  const robot::Mounting& mounting() const override { return machine_.task_.mounting; }
  std::span<const double> q() const override { return machine_.q_; }
  std::span<const double> goal() const override { return machine_.target_.q; }
  const math::Vec3& p_WG() const override { return machine_.target_.p_WG; }
  double seconds() const override {
    return seconds_from_ticks(machine_.time_ - machine_.task_.start);
  }
  double distance_to_goal() const override { return machine_.tool_distance(machine_.target_.p_WG); }
  bool would_accept(int parameter, double direction) override {
    return machine_.would_accept(parameter, direction, world_);
  }
  double free_distance(double heading_deg) const override {
    return world_.free_distance(machine_.q_, heading_deg, machine_.model_->sensor);
  }
  bool is_met_moving(double heading_deg) const override {
    return world_.is_met_moving(machine_.q_, heading_deg, machine_.model_->sensor);
  }
  const WayLog& way() const override { return machine_.way_; }

 private:
  Machine& machine_;
  const World& world_;
};

Machine::Value Machine::evaluate(const Code& code, const World& world) {
  // The operands of one expression; they stand on top of what is there already.
  const std::size_t base = operands_.size();
  const auto pop = [&] {
    const double value = operands_.back().number;
    operands_.pop_back();
    return value;
  };
  const auto push = [&](double value) { operands_.push_back({value, -1, false, false}); };
  for (std::int32_t i = code.begin; i < code.end; ++i) {
    const ExpressionOp& op = program_->code[static_cast<std::size_t>(i)];
    const auto slot = static_cast<std::size_t>(op.index);
    switch (op.kind) {
      case OpKind::constant:
        push(op.value);
        break;
      case OpKind::parameter:
        push(q_[slot]);
        break;
      case OpKind::variable:
        if (!variables_[slot].set) {
          operands_.resize(base);
          throw RunTimeError{
              fmt::format("variable '{}' is read before it is set", program_->variables[slot]),
              op.span};
        }
        operands_.push_back(variables_[slot].value);
        break;
      case OpKind::call:
        call(op, world);
        break;
      case OpKind::negate:
        operands_.back().number = -operands_.back().number;
        operands_.back().negated = !operands_.back().negated;
        operands_.back().is_place = false;
        break;
      case OpKind::plus:
        break;
      case OpKind::logical_not:
        push(truth(pop() == 0));
        break;
      case OpKind::skip_if_false:
        if (operands_.back().number == 0) {
          i = op.index - 1;
        } else {
          operands_.pop_back();
        }
        break;
      case OpKind::skip_if_true:
        if (operands_.back().number != 0) {
          i = op.index - 1;
        } else {
          operands_.pop_back();
        }
        break;
      default: {
        const double b = pop();
        const double a = pop();
        switch (op.kind) {
          case OpKind::add:
            push(a + b);
            break;
          case OpKind::subtract:
            push(a - b);
            break;
          case OpKind::multiply:
            push(a * b);
            break;
          case OpKind::divide:
            if (b == 0) {
              operands_.resize(base);
              throw RunTimeError{"division by zero", op.span};
            }
            push(a / b);
            break;
          case OpKind::equal:
            push(truth(std::fabs(a - b) <= kEpsilon));
            break;
          case OpKind::not_equal:
            push(truth(std::fabs(a - b) > kEpsilon));
            break;
          case OpKind::less:
            push(truth(a < b - kEpsilon));
            break;
          case OpKind::less_equal:
            push(truth(a <= b + kEpsilon));
            break;
          case OpKind::greater:
            push(truth(a > b + kEpsilon));
            break;
          case OpKind::greater_equal:
            push(truth(a >= b - kEpsilon));
            break;
          default:
            break;
        }
      }
    }
    // `and` and `or` have just taken their left side away.
    if (operands_.size() > base && !std::isfinite(operands_.back().number)) {
      operands_.resize(base);
      throw RunTimeError{"the value is not finite", op.span};
    }
  }
  const Value value = operands_.back();
  operands_.resize(base);
  return value;
}

void Machine::call(const ExpressionOp& op, const World& world) {
  const Function& function = functions()[op.function];
  std::array<double, kMostArguments> values{};
  const std::size_t count = function.argument_count() - (function.takes_parameter() ? 1 : 0);
  for (std::size_t i = count; i > 0; --i) {
    const Value& operand = operands_.back();
    const std::size_t argument = i - 1 + (function.takes_parameter() ? 1 : 0);
    if (function.arguments[argument] == Argument::place && !operand.is_place) {
      throw RunTimeError{fmt::format("{} needs a place on the way: var(hit) = here(); and then "
                                     "var(hit)",
                                     function.name),
                         op.span};
    }
    values[i - 1] = operand.number;
    operands_.pop_back();
  }
  Scope scope(*this, world);
  const double number = function.evaluate(scope, op.index, {values.data(), count});
  const bool is_direction = function.result == Result::direction;
  operands_.push_back(
      {number, is_direction ? op.index : -1, false, function.result == Result::place});
}

double Machine::delta(int index, double value) const {
  return robot::way_between(parameter(index), q_[static_cast<std::size_t>(index)], value);
}

bool Machine::at(int index, double value) const {
  return std::fabs(delta(index, value)) <= kEpsilon * parameter(index).quantum;
}

/// What a variable keeps: a direction that is 0 becomes the preferred one of its parameter.
Machine::Value Machine::stored(const Value& value) const {
  if (value.direction_of < 0 || value.number != 0) return value;
  Value kept = value;
  kept.number = parameter(value.direction_of).prefer * (value.negated ? -1.0 : 1.0);
  return kept;
}

}  // namespace rubicon::interpreter
