#include "src/motion/robot/chain_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/enclosed_point.hpp"
#include "src/motion/robot/frame_chain.hpp"

namespace rubicon::robot {
namespace {

/// Longer formulas are left to interval arithmetic.
constexpr std::size_t kLongest = 16;

/// Part of the values that were added and subtracted by which a sum may be wrong.
constexpr double kSumRounding = 1e-14;

/// Runs the last operation of two operands; false where the result is not linear.
bool combine(FormulaOp::Kind kind, LinearValue& a, const LinearValue& b) {
  switch (kind) {
    case FormulaOp::Kind::add:
      a = {a.at0 + b.at0, a.rate + b.rate};
      return true;
    case FormulaOp::Kind::subtract:
      a = {a.at0 - b.at0, a.rate - b.rate};
      return true;
    case FormulaOp::Kind::multiply:
      if (a.rate != 0 && b.rate != 0) return false;
      a = {a.at0 * b.at0, a.at0 * b.rate + a.rate * b.at0};
      return true;
    case FormulaOp::Kind::divide:
      if (b.rate != 0 || b.at0 == 0) return false;
      a = {a.at0 / b.at0, a.rate / b.at0};
      return true;
    default:
      return false;
  }
}

}  // namespace

std::optional<LinearValue> linear_value(const Formula& formula, std::span<const double> q0,
                                        std::span<const double> q1,
                                        std::span<const double> starts) {
  using Kind = FormulaOp::Kind;
  if (formula.code.empty()) return LinearValue{};
  if (formula.code.size() > kLongest) return std::nullopt;
  std::array<LinearValue, kLongest> stack;
  std::size_t size = 0;
  for (const FormulaOp& op : formula.code) {
    const auto index = static_cast<std::size_t>(op.index);
    switch (op.kind) {
      case Kind::constant:
        stack[size++] = {op.value, 0};
        break;
      case Kind::parameter:
        stack[size++] = {q0[index], q1[index] - q0[index]};
        break;
      case Kind::step:
        stack[size++] = {};
        break;
      case Kind::start:
        stack[size++] = {starts[index], 0};
        break;
      case Kind::negate:
        stack[size - 1] = {-stack[size - 1].at0, -stack[size - 1].rate};
        break;
      case Kind::sin:
      case Kind::cos: {
        LinearValue& angle = stack[size - 1];
        if (angle.rate != 0) return std::nullopt;
        angle.at0 = op.kind == Kind::sin ? math::sin_deg(angle.at0) : math::cos_deg(angle.at0);
        break;
      }
      default:
        --size;
        if (!combine(op.kind, stack[size - 1], stack[size])) return std::nullopt;
    }
  }
  return stack[0];
}

void ChainBound::append(const FrameElement& element, std::span<const double> q0,
                        std::span<const double> q1, std::span<const double> starts) {
  if (!linear_) return;
  const auto a = linear_value(element.a, q0, q1, starts);
  if (element.kind != FrameElement::Kind::trans) {
    linear_ = a.has_value();
    if (a) append_turn(rotation_axis_index(element.kind), math::radians(a->rate));
    return;
  }
  const auto b = linear_value(element.b, q0, q1, starts);
  const auto c = linear_value(element.c, q0, q1, starts);
  linear_ = a && b && c;
  if (linear_) append_translation({a->at0, b->at0, c->at0}, {a->rate, b->rate, c->rate});
}

void ChainBound::append_turn(int axis, double rate) {
  if (axis != last_axis_) {
    end_row();
    last_axis_ = axis;
  }
  last_sum_ += rate;
  last_magnitude_ += std::fabs(rate);
}

void ChainBound::end_row() {
  earlier_rates_ += last_rate();
  last_axis_ = -1;
  last_sum_ = 0;
  last_magnitude_ = 0;
}

double ChainBound::last_rate() const {
  return std::fabs(last_sum_) + kSumRounding * last_magnitude_;
}

void ChainBound::append_lengths(double along, double across, double along_grows,
                                double across_grows) {
  const auto add = [&](double rates, double length, double grows) {
    origin_ += rates * (rates * length + 2 * grows);
  };
  add(earlier_rates_, along, along_grows);
  add(earlier_rates_ + last_rate(), across, across_grows);
}

void ChainBound::append_translation(const Vec3& at0, const Vec3& rate) {
  const Vec3 end = at0 + rate;
  Vec3 along = Vec3::Zero();
  if (last_axis_ >= 0) along[last_axis_] = 1;
  const Vec3 across = Vec3::Ones() - along;
  const auto length = [](const Vec3& v, const Vec3& part) { return v.cwiseProduct(part).norm(); };
  // The length of a vector that runs linearly is greatest at an end.
  append_lengths(std::max(length(at0, along), length(end, along)),
                 std::max(length(at0, across), length(end, across)), length(rate, along),
                 length(rate, across));
}

void ChainBound::append_constant(double along, double across) {
  append_lengths(along, across, 0, 0);
}

std::optional<AccelerationBound> ChainBound::bound() const {
  if (!linear_) return std::nullopt;
  const double rates = earlier_rates_ + last_rate();
  return AccelerationBound{origin_ * kBoundRounding, rates * rates * kBoundRounding};
}

}  // namespace rubicon::robot
