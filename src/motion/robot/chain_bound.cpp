#include "src/motion/robot/chain_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/enclosed_point.hpp"

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
    if (a) append_rotation(element.kind, math::radians(a->rate));
    return;
  }
  const auto b = linear_value(element.b, q0, q1, starts);
  const auto c = linear_value(element.c, q0, q1, starts);
  linear_ = a && b && c;
  if (linear_) append_translation(*a, *b, *c);
}

void ChainBound::append_rotation(FrameElement::Kind axis, double rate) {
  if (axis != last_axis_) {
    earlier_rates_ += last_rate();
    last_axis_ = axis;
    last_sum_ = 0;
    last_magnitude_ = 0;
  }
  last_sum_ += rate;
  last_magnitude_ += std::fabs(rate);
}

double ChainBound::last_rate() const {
  return std::fabs(last_sum_) + kSumRounding * last_magnitude_;
}

void ChainBound::append_translation(const LinearValue& x, const LinearValue& y,
                                    const LinearValue& z) {
  const Vec3 start(x.at0, y.at0, z.at0);
  const Vec3 rate(x.rate, y.rate, z.rate);
  const Vec3 end = start + rate;
  Vec3 along = Vec3::Zero();
  if (last_axis_ != FrameElement::Kind::trans) {
    along[last_axis_ == FrameElement::Kind::rotx   ? 0
          : last_axis_ == FrameElement::Kind::roty ? 1
                                                   : 2] = 1;
  }
  const Vec3 across = Vec3::Ones() - along;
  // The length of a vector that runs linearly is greatest at an end.
  const auto add = [&](const Vec3& part, double rates) {
    const double length = std::max(start.cwiseProduct(part).norm(), end.cwiseProduct(part).norm());
    const double grows = rate.cwiseProduct(part).norm();
    origin_ += rates * (rates * length + 2 * grows);
    origin_speed_ += rates * length + grows;
  };
  add(along, earlier_rates_);
  add(across, earlier_rates_ + last_rate());
}

std::optional<AccelerationBound> ChainBound::bound() const {
  if (!linear_) return std::nullopt;
  const double rates = earlier_rates_ + last_rate();
  return AccelerationBound{origin_ * kBoundRounding, rates * rates * kBoundRounding};
}

std::optional<SpeedBound> ChainBound::speed() const {
  if (!linear_) return std::nullopt;
  const double rates = earlier_rates_ + last_rate();
  return SpeedBound{origin_speed_ * kBoundRounding, rates * kBoundRounding};
}

}  // namespace rubicon::robot
