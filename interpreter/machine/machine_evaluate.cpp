#include <fmt/format.h>

#include <cmath>

#include "interpreter/machine/machine.hpp"
#include "interpreter/machine/run_time_error.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter {

namespace {

using OpKind = ExpressionOp::Kind;

double truth(bool holds) { return holds ? 1.0 : 0.0; }

}  // namespace

Machine::Value Machine::evaluate(const Code& code, const World& world) {
  // The operands of one expression; `clear` may come back here, so they stand on top of what is
  // there already.
  const std::size_t base = operands_.size();
  const auto pop = [&] {
    const double value = operands_.back().number;
    operands_.pop_back();
    return value;
  };
  const auto push = [&](double value) { operands_.push_back({value, -1, false}); };
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
      case OpKind::goal:
        push(goal_.q[slot]);
        break;
      case OpKind::relative_goal:
        push(robot::relative_goal(*model_, task_.mounting, q_, op.index, goal_.p_WG));
        break;
      case OpKind::direction: {
        const double off = delta(op.index, pop());
        // A whole step must get nearer: a dead band of half a step, else robots turn to and fro for
        // ever.
        const double sign =
            std::fabs(off) <= parameter(op.index).quantum / 2 ? 0.0 : (off > 0 ? 1.0 : -1.0);
        operands_.push_back({sign, op.index, false});
        break;
      }
      case OpKind::axis:
        push(nearest_axis(op.index, pop()));
        break;
      case OpKind::lower_limit:
        push(parameter(op.index).lower);
        break;
      case OpKind::upper_limit:
        push(parameter(op.index).upper);
        break;
      case OpKind::smaller_of:
        push(std::min(q_[slot], pop()));
        break;
      case OpKind::larger_of:
        push(std::max(q_[slot], pop()));
        break;
      case OpKind::distance:
        push(tool_distance());
        break;
      case OpKind::parameter_distance:
        push(std::fabs(delta(op.index, pop())));
        break;
      case OpKind::clear:
        push(truth(would_accept(op.index, pop(), world)));
        break;
      case OpKind::free:
        push(world.free_distance(q_, pop(), model_->sensor));
        break;
      case OpKind::time:
        push(seconds_from_ticks(time_ - task_.start));
        break;
      case OpKind::absolute:
        push(std::fabs(pop()));
        break;
      case OpKind::sine:
        push(math::sin_deg(pop()));
        break;
      case OpKind::cosine:
        push(math::cos_deg(pop()));
        break;
      case OpKind::negate:
        operands_.back().number = -operands_.back().number;
        operands_.back().negated = !operands_.back().negated;
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

/// value - q(p), the short way round for a cyclic parameter.
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

double Machine::nearest_axis(int index, double value) const {
  return robot::nearest_axis(parameter(index), value, q_[static_cast<std::size_t>(index)]);
}

}  // namespace rubicon::interpreter
