#include "src/motion/robot/formula.hpp"

#include <array>
#include <cassert>
#include <memory>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/enclosure.hpp"

namespace rubicon::robot {
namespace {

/// A value with its derivative along a direction.
struct Dual {
  double value = 0;
  double slope = 0;
};

Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
Dual operator-(Dual a) { return {-a.value, -a.slope}; }
Dual operator*(Dual a, Dual b) {
  return {a.value * b.value, a.slope * b.value + a.value * b.slope};
}
Dual operator/(Dual a, Dual b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.slope - quotient * b.slope) / b.value};
}
Dual sine(Dual a) {
  return {math::sin_deg(a.value), math::cos_deg(a.value) * math::radians(a.slope)};
}
Dual cosine(Dual a) {
  return {math::cos_deg(a.value), -math::sin_deg(a.value) * math::radians(a.slope)};
}

/// Brings the memo to an angle.
void remember(TrigonometryMemo& memo, double degrees) {
  if (degrees == memo.degrees) return;
  const auto [sine, cosine] = math::sine_cosine_deg(degrees);
  memo = {degrees, sine, cosine};
}

/// A plain number; knows where sines and cosines are remembered.
struct Number {
  double value;
  TrigonometryMemo* memo;
};

Number operator+(Number a, Number b) { return {a.value + b.value, a.memo}; }
Number operator-(Number a, Number b) { return {a.value - b.value, a.memo}; }
Number operator-(Number a) { return {-a.value, a.memo}; }
Number operator*(Number a, Number b) { return {a.value * b.value, a.memo}; }
Number operator/(Number a, Number b) { return {a.value / b.value, a.memo}; }
Number sine(Number a) {
  remember(*a.memo, a.value);
  return {a.memo->sine, a.memo};
}
Number cosine(Number a) {
  remember(*a.memo, a.value);
  return {a.memo->cosine, a.memo};
}

double sine(double a) { return math::sin_deg(a); }
double cosine(double a) { return math::cos_deg(a); }

/// Runs postfix code on a stack large enough for it; `leaf` gives the value of an operand.
template <class Value, class Leaf>
Value run_on(Value* stack, const std::vector<FormulaOp>& code, const Leaf& leaf) {
  using Kind = FormulaOp::Kind;
  Value* top = stack;  // one past the last value
  for (const FormulaOp& op : code) {
    switch (op.kind) {
      case Kind::constant:
      case Kind::parameter:
      case Kind::step:
      case Kind::start:
        *top++ = leaf(op);
        continue;
      case Kind::negate:
        assert(top > stack);
        top[-1] = -top[-1];
        continue;
      case Kind::sin:
        assert(top > stack);
        top[-1] = sine(top[-1]);
        continue;
      case Kind::cos:
        assert(top > stack);
        top[-1] = cosine(top[-1]);
        continue;
      default:
        break;
    }
    assert(top - stack >= 2);
    --top;
    switch (op.kind) {
      case Kind::add:
        top[-1] = top[-1] + top[0];
        break;
      case Kind::subtract:
        top[-1] = top[-1] - top[0];
        break;
      case Kind::multiply:
        top[-1] = top[-1] * top[0];
        break;
      default:
        top[-1] = top[-1] / top[0];
        break;
    }
  }
  assert(top == stack + 1);
  return stack[0];
}

/// Postfix code needs at most one place for every two operations; short code, which is nearly all,
/// gets no allocation.
template <class Value, class Leaf>
Value run(const std::vector<FormulaOp>& code, const Leaf& leaf) {
  constexpr std::size_t kInline = 16;
  if (code.size() < 2 * kInline) {
    std::array<Value, kInline + 1> stack;
    return run_on(stack.data(), code, leaf);
  }
  const auto stack = std::make_unique<Value[]>(code.size());
  return run_on(stack.get(), code, leaf);
}

double operand(const FormulaOp& op, const FormulaInput& input) {
  const auto index = static_cast<std::size_t>(op.index);
  switch (op.kind) {
    case FormulaOp::Kind::parameter:
      return input.q[index];
    case FormulaOp::Kind::step:
      return input.steps.empty() ? 0 : input.steps[index];
    case FormulaOp::Kind::start:
      return input.starts[index];
    default:
      return op.value;
  }
}

}  // namespace

double Formula::evaluate(const FormulaInput& input) const {
  if (code.empty()) return 0;
  if (code.size() == 1) return operand(code[0], input);
  return run<double>(code, [&](const FormulaOp& op) { return operand(op, input); });
}

double Formula::evaluate(const FormulaInput& input, TrigonometryMemo& memo) const {
  if (code.empty()) return 0;
  if (code.size() == 1) return operand(code[0], input);
  return run<Number>(code,
                     [&](const FormulaOp& op) {
                       return Number{operand(op, input), &memo};
                     })
      .value;
}

double Formula::derivative(const FormulaInput& input, int index) const {
  if (!depends_on_parameter(index)) return 0;
  return run<Dual>(code,
                   [&](const FormulaOp& op) {
                     const bool chosen = op.kind == FormulaOp::Kind::parameter && op.index == index;
                     return Dual{operand(op, input), chosen ? 1.0 : 0.0};
                   })
      .slope;
}

double Formula::derivative(const FormulaInput& input, std::span<const double> direction) const {
  if (code.empty()) return 0;
  return run<Dual>(code,
                   [&](const FormulaOp& op) {
                     const bool moves = op.kind == FormulaOp::Kind::parameter;
                     return Dual{operand(op, input),
                                 moves ? direction[static_cast<std::size_t>(op.index)] : 0.0};
                   })
      .slope;
}

Enclosure Formula::enclose(std::span<const double> q0, std::span<const double> q1,
                           std::span<const double> starts, double s0, double s1) const {
  if (code.empty()) return {};
  return run<Enclosure>(code, [&](const FormulaOp& op) {
    if (op.kind != FormulaOp::Kind::parameter)
      return constant_enclosure(operand(op, {q0, {}, starts}));
    const auto index = static_cast<std::size_t>(op.index);
    if (q0[index] == q1[index]) return constant_enclosure(q0[index]);
    const Interval rate = point_interval(q1[index]) - point_interval(q0[index]);
    return Enclosure{point_interval(q0[index]) + Interval{s0, s1} * rate, rate, {}};
  });
}

bool Formula::depends_on_parameter(int index) const {
  for (const FormulaOp& op : code) {
    if (op.kind == FormulaOp::Kind::parameter && op.index == index) return true;
  }
  return false;
}

bool Formula::depends_on_step(int index) const {
  for (const FormulaOp& op : code) {
    if (op.kind == FormulaOp::Kind::step && op.index == index) return true;
  }
  return false;
}

Formula constant_formula(double value) { return {{{FormulaOp::Kind::constant, 0, value}}}; }

Formula parameter_formula(int index) { return {{{FormulaOp::Kind::parameter, index, 0}}}; }

}  // namespace rubicon::robot
