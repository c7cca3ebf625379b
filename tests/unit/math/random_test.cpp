#include "src/motion/math/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubicon::math {
namespace {

TEST(Random, LogarithmAndExponentialAreThoseOfTheLibrary) {
  for (double x = 1e-12; x < 1e12; x *= 1.37) {
    EXPECT_NEAR(log_of(x), std::log(x), 1e-13 * std::max(1.0, std::fabs(std::log(x))));
    EXPECT_NEAR(exp_of(std::log(x)) / x, 1, 1e-13);
  }
}

TEST(Random, TheSameSeedGivesTheSameBits) {
  Random random(7);
  EXPECT_EQ(random.bits(), 7191089600892374487ull);
  EXPECT_EQ(Random(7).bits(), Random(7).bits());
  EXPECT_NE(Random(7).bits(), Random(8).bits());
}

TEST(Random, BetaHasItsMeanAndVariance) {
  const double shapes[][2] = {{1, 1}, {1, 4}, {3, 1}, {2.5, 1.5}, {10, 30}};
  for (const auto& [a, b] : shapes) {
    Random random(3);
    double sum = 0;
    double squares = 0;
    constexpr int kDraws = 100'000;
    for (int n = 0; n < kDraws; ++n) {
      const double x = random.beta(a, b);
      ASSERT_TRUE(x >= 0 && x <= 1);
      sum += x;
      squares += x * x;
    }
    const double mean = a / (a + b);
    const double variance = a * b / ((a + b) * (a + b) * (a + b + 1));
    EXPECT_NEAR(sum / kDraws, mean, 0.005);
    EXPECT_NEAR(squares / kDraws - mean * mean, variance, 0.005);
  }
}

}  // namespace
}  // namespace rubicon::math
