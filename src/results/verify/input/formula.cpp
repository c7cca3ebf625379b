#include "src/results/verify/input/formula.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "src/motion/math/angles.hpp"
#include "src/results/verify/input/formula_parser.hpp"

namespace rubicon::verify {

namespace {

Range operator+(Range a, Range b) { return {a.lower + b.lower, a.upper + b.upper}; }
Range operator-(Range a, Range b) { return {a.lower - b.upper, a.upper - b.lower}; }
Range operator-(Range a) { return {-a.upper, -a.lower}; }

Range operator*(Range a, Range b) {
  const std::array<double, 4> products = {a.lower * b.lower, a.lower * b.upper, a.upper * b.lower,
                                          a.upper * b.upper};
  const auto [least, most] = std::minmax_element(products.begin(), products.end());
  return {*least, *most};
}

Range operator/(Range a, Range b) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (b.lower <= 0 && b.upper >= 0) return {-kInfinity, kInfinity};
  return a * Range{1 / b.upper, 1 / b.lower};
}

/// Whether the range holds `angle` + 360 k for some k.
bool holds_angle(Range degrees, double angle) {
  return angle + 360 * std::ceil((degrees.lower - angle) / 360) <= degrees.upper;
}

Range sine(Range degrees) {
  if (!(degrees.upper - degrees.lower < 360)) return {-1, 1};
  const double a = math::sin_deg(degrees.lower);
  const double b = math::sin_deg(degrees.upper);
  Range result{std::min(a, b), std::max(a, b)};
  if (holds_angle(degrees, 90)) result.upper = 1;
  if (holds_angle(degrees, -90)) result.lower = -1;
  return result;
}

Range cosine(Range degrees) { return sine({degrees.lower + 90, degrees.upper + 90}); }

/// The operands of an evaluation. The parser has seen to it that they are there.
template <typename T>
class Operands {
 public:
  void push(T value) { values_.push_back(value); }
  T pop() {
    const T top = values_.back();
    values_.pop_back();
    return top;
  }

 private:
  std::vector<T> values_;
};

}  // namespace

Formula Formula::parse(std::string_view text, const std::vector<std::string>& parameters) {
  FormulaParser parser(text, parameters);
  Formula formula = parser.formula();
  parser.expect_end();
  return formula;
}

bool Formula::uses(std::size_t parameter) const {
  return std::any_of(code_.begin(), code_.end(), [&](const Op& op) {
    return op.kind == Kind::value && op.parameter == parameter;
  });
}

double Formula::value(const FormulaValues& at) const {
  if (code_.empty()) return 0;
  // Most formulas are a single number or parameter.
  if (code_.size() == 1 && code_[0].kind == Kind::number) return code_[0].number;
  if (code_.size() == 1 && code_[0].kind == Kind::value) return at.values[code_[0].parameter];
  Operands<double> stack;
  const auto two = [&](auto join) {
    const double right = stack.pop();
    stack.push(join(stack.pop(), right));
  };
  for (const Op& op : code_) {
    switch (op.kind) {
      case Kind::number:
        stack.push(op.number);
        break;
      case Kind::value:
        stack.push(at.values[op.parameter]);
        break;
      case Kind::step:
        stack.push(at.steps.empty() ? 0 : at.steps[op.parameter]);
        break;
      case Kind::start:
        stack.push(at.starts[op.parameter]);
        break;
      case Kind::add:
        two([](double a, double b) { return a + b; });
        break;
      case Kind::subtract:
        two([](double a, double b) { return a - b; });
        break;
      case Kind::multiply:
        two([](double a, double b) { return a * b; });
        break;
      case Kind::divide:
        two([](double a, double b) { return a / b; });
        break;
      case Kind::negate:
        stack.push(-stack.pop());
        break;
      case Kind::sin:
        stack.push(math::sin_deg(stack.pop()));
        break;
      case Kind::cos:
        stack.push(math::cos_deg(stack.pop()));
        break;
    }
  }
  return stack.pop();
}

Range Formula::range(std::span<const Range> parameters, std::span<const double> starts) const {
  if (code_.empty()) return {0, 0};
  Operands<Range> stack;
  const auto two = [&](auto join) {
    const Range right = stack.pop();
    stack.push(join(stack.pop(), right));
  };
  for (const Op& op : code_) {
    switch (op.kind) {
      case Kind::number:
        stack.push({op.number, op.number});
        break;
      case Kind::value:
        stack.push(parameters[op.parameter]);
        break;
      case Kind::step:
        stack.push({0, 0});
        break;
      case Kind::start:
        stack.push({starts[op.parameter], starts[op.parameter]});
        break;
      case Kind::add:
        two([](Range a, Range b) { return a + b; });
        break;
      case Kind::subtract:
        two([](Range a, Range b) { return a - b; });
        break;
      case Kind::multiply:
        two([](Range a, Range b) { return a * b; });
        break;
      case Kind::divide:
        two([](Range a, Range b) { return a / b; });
        break;
      case Kind::negate:
        stack.push(-stack.pop());
        break;
      case Kind::sin:
        stack.push(sine(stack.pop()));
        break;
      case Kind::cos:
        stack.push(cosine(stack.pop()));
        break;
    }
  }
  return stack.pop();
}

}  // namespace rubicon::verify
