#include "src/motion/robot/formula.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/motion/math/angles.hpp"
#include "tests/unit/robot/robots.hpp"

namespace rubicon::robot {
namespace {

/// A random formula over three parameters; divisors stay away from 0 unless `wild`.
Formula random_formula(std::mt19937_64& random, int depth) {
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  if (depth == 0) {
    return pick(4) == 0 ? number(pick(7) - 3.0) : of(pick(3));
  }
  const Formula a = random_formula(random, depth - 1);
  const Formula b = random_formula(random, depth - 1);
  switch (pick(7)) {
    case 0:
      return a + b;
    case 1:
      return a - b;
    case 2:
      return a * b;
    case 3:
      return -a;
    case 4:
      return sin_of(a);
    case 5:
      return a / (number(3) + sin_of(b));
    default:
      return cos_of(a);
  }
}

TEST(Formula, EvaluatesInPostfixOrder) {
  const std::vector<double> q = {7, 2};
  const std::vector<double> steps = {0.5, 0};
  const std::vector<double> starts = {10, 20};
  const FormulaInput input = {q, steps, starts};
  EXPECT_EQ((of(0) - of(1)).evaluate(input), 5);
  EXPECT_EQ((of(0) / of(1)).evaluate(input), 3.5);
  EXPECT_EQ((start_of(1) + step_of(0) * -of(1)).evaluate(input), 19);
  EXPECT_EQ(sin_of(number(15) * of(1)).evaluate(input), 0.5);
  EXPECT_EQ(cos_of(number(30) * of(1)).evaluate(input), 0.5);
  EXPECT_EQ(Formula().evaluate(input), 0);
  EXPECT_EQ(step_of(0).evaluate({q, {}, starts}), 0);
}

TEST(Formula, RememberedSinesChangeNothing) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> value(-300, 300);
  TrigonometryMemo memo;
  for (int i = 0; i < 2000; ++i) {
    const Formula formula = random_formula(random, 3);
    const std::vector<double> q = {value(random), 90, value(random)};
    EXPECT_EQ(formula.evaluate({q, {}, {}}, memo), formula.evaluate({q, {}, {}}));
  }
}

TEST(Formula, LongCodeIsEvaluatedAsWell) {
  Formula right = number(1);
  for (int i = 0; i < 200; ++i) right = of(0) + right;  // deep: all operands before all operations
  const std::vector<double> q = {2};
  EXPECT_EQ(right.evaluate({q, {}, {}}), 401);
  EXPECT_EQ(right.derivative({q, {}, {}}, 0), 200);
  EXPECT_NEAR(right.enclose(q, std::vector<double>{3}, {}, 0, 1).first.upper, 200, 1e-10);
}

TEST(Formula, KnowsWhatItReads) {
  const Formula formula = of(2) + step_of(1) * start_of(0);
  EXPECT_TRUE(formula.depends_on_parameter(2));
  EXPECT_FALSE(formula.depends_on_parameter(1));
  EXPECT_FALSE(formula.depends_on_parameter(0));
  EXPECT_TRUE(formula.depends_on_step(1));
  EXPECT_FALSE(formula.depends_on_step(2));
}

TEST(Formula, DerivativesAgreeWithDifferences) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> value(-3, 3);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 2000; ++i) {
    const Formula formula = random_formula(random, 4);
    std::vector<double> q = {value(random), value(random), value(random)};
    for (int p = 0; p < 3; ++p) {
      const double derivative = formula.derivative({q, {}, {}}, p);
      auto up = q, down = q;
      up[static_cast<std::size_t>(p)] += kStep;
      down[static_cast<std::size_t>(p)] -= kStep;
      const double high = formula.evaluate({up, {}, {}});
      const double low = formula.evaluate({down, {}, {}});
      EXPECT_NEAR(derivative, (high - low) / (2 * kStep),
                  1e-4 * (1 + std::fabs(derivative) + std::fabs(high)));
    }
    std::vector<double> direction = {1, -2, 0.5};
    const double along = formula.derivative({q, {}, {}}, direction);
    const double summed = formula.derivative({q, {}, {}}, 0) -
                          2 * formula.derivative({q, {}, {}}, 1) +
                          0.5 * formula.derivative({q, {}, {}}, 2);
    EXPECT_NEAR(along, summed, 1e-9 * (1 + std::fabs(along)));
  }
}

TEST(Formula, EnclosuresHoldValueAndBothDerivatives) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> value(-200, 200);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 3000; ++i) {
    const Formula formula = random_formula(random, 3);
    const std::vector<double> q0 = {value(random), value(random), value(random)};
    const std::vector<double> q1 = {q0[0] + value(random) / 3, q0[1] + value(random) / 10, q0[2]};
    double s0 = unit(random), s1 = unit(random);
    if (s0 > s1) std::swap(s0, s1);
    const Enclosure enclosure = formula.enclose(q0, q1, {}, s0, s1);
    const auto at = [&](double s) {
      const std::vector<double> q = {q0[0] + s * (q1[0] - q0[0]), q0[1] + s * (q1[1] - q0[1]),
                                     q0[2]};
      return q;
    };
    std::vector<double> rates = {q1[0] - q0[0], q1[1] - q0[1], 0};
    for (int k = 0; k <= 20; ++k) {
      const double s = s0 + (s1 - s0) * k / 20;
      const double f = formula.evaluate({at(s), {}, {}});
      const double slope = formula.derivative({at(s), {}, {}}, rates);
      const double slack = 1e-9 * (1 + std::fabs(f));
      EXPECT_GE(f, enclosure.value.lower - slack);
      EXPECT_LE(f, enclosure.value.upper + slack);
      const double slope_slack = 1e-9 * (1 + std::fabs(slope));
      EXPECT_GE(slope, enclosure.first.lower - slope_slack);
      EXPECT_LE(slope, enclosure.first.upper + slope_slack);
      // The second derivative by the mean value theorem: every difference quotient of the slope is
      // one of its values.
      const double t = std::min(s1, s + (s1 - s0) / 20);
      if (t - s < 1e-3) continue;
      const double quotient = (formula.derivative({at(t), {}, {}}, rates) - slope) / (t - s);
      const double second_slack = 1e-7 * (1 + std::fabs(quotient) + std::fabs(slope));
      EXPECT_GE(quotient, enclosure.second.lower - second_slack);
      EXPECT_LE(quotient, enclosure.second.upper + second_slack);
    }
  }
}

TEST(Formula, LinearFormulasHaveExactlyNoSecondDerivative) {
  const Formula formula = number(3) * of(0) + of(1) * sin_of(of(2)) - number(0.1) * of(1);
  const Enclosure enclosure =
      formula.enclose(std::vector<double>{1, 2, 33}, std::vector<double>{4, -7.3, 33}, {}, 0, 1);
  EXPECT_EQ(enclosure.second.lower, 0);
  EXPECT_EQ(enclosure.second.upper, 0);
  const Enclosure curved =
      (of(0) * of(1))
          .enclose(std::vector<double>{1, 2, 33}, std::vector<double>{4, -7.3, 33}, {}, 0, 1);
  EXPECT_LE(curved.second.lower, 2 * 3 * -9.3);
  EXPECT_LT(curved.second.upper, 0);
}

TEST(Formula, ADivisorThatMayVanishIsUnbounded) {
  const Enclosure enclosure =
      (number(1) / of(0)).enclose(std::vector<double>{-1}, std::vector<double>{1}, {}, 0, 1);
  EXPECT_TRUE(std::isinf(enclosure.value.upper));
  EXPECT_TRUE(std::isinf(enclosure.second.upper));
}

}  // namespace
}  // namespace rubicon::robot
