#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "src/motion/math/random.hpp"
#include "src/studies/statistics/bootstrap.hpp"
#include "src/studies/statistics/mean.hpp"
#include "src/studies/statistics/pareto.hpp"
#include "src/studies/statistics/quantile.hpp"
#include "src/studies/statistics/rank.hpp"

namespace rubicon::statistics {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(Student, AgreesWithItsTable) {
  // Published two-sided 95 % points.
  const std::pair<std::size_t, double> points[] = {{1, 12.7062}, {5, 2.5706},  {9, 2.2622},
                                                   {10, 2.2281}, {20, 2.0860}, {30, 2.0423},
                                                   {60, 2.0003}, {120, 1.9799}};
  for (const auto& [degrees, value] : points) EXPECT_NEAR(student_975(degrees), value, 1e-4);
  for (std::size_t n = 1; n < 200; ++n) EXPECT_GT(student_975(n), student_975(n + 1));
}

TEST(Mean, OfNumbersWorkedOutByHand) {
  const Mean mean = mean_of(std::vector<double>{2, 4, 4, 4, 5, 5, 7, 9});
  EXPECT_EQ(mean.count, 8u);
  EXPECT_DOUBLE_EQ(mean.mean, 5);
  EXPECT_DOUBLE_EQ(mean.deviation, std::sqrt(32.0 / 7));
  EXPECT_NEAR(mean.interval->width() / 2, 2.36462 * std::sqrt(32.0 / 7 / 8), 1e-4);
  EXPECT_FALSE(mean_of(std::vector<double>{3}).interval);
  EXPECT_EQ(mean_of(std::vector<double>(7, 1e9 / 3)).deviation, 0);
  EXPECT_EQ(mean_of({}).count, 0u);
}

TEST(Quantile, IsTheLeastWithItsShareBelow) {
  const std::vector<double> ten = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_EQ(quantile(ten, 0.5), 5);
  EXPECT_EQ(quantile(ten, 0.8), 8);
  EXPECT_EQ(quantile(ten, 0.81), 9);
  EXPECT_EQ(quantile(ten, 0.1), 1);
  EXPECT_EQ(quantile(ten, 1), 10);
  EXPECT_EQ(quantile(std::vector<double>{1, 2, kNever, kNever}, 0.5), 2);
  EXPECT_EQ(quantile(std::vector<double>{1, 2, kNever, kNever}, 0.51), kNever);
}

/// The exact chance that the ranks bound the quantile, by Pascal's triangle.
double chance_of(const QuantileRanks& ranks, std::size_t count, double p) {
  std::vector<double> share(count + 1, 0.0);
  share[0] = 1;
  for (std::size_t n = 0; n < count; ++n) {
    for (std::size_t k = n + 1; k > 0; --k) share[k] = share[k] * (1 - p) + share[k - 1] * p;
    share[0] *= 1 - p;
  }
  double sum = 0;
  for (std::size_t k = ranks.low.value_or(0); k < ranks.high.value_or(count + 1); ++k) {
    sum += share[k];
  }
  return sum;
}

TEST(QuantileRanks, HoldWith95PercentAndNotMuchMore) {
  for (const std::size_t count : {6u, 20u, 50u, 100u, 200u, 500u, 1000u}) {
    for (const double p : {0.1, 0.5, 0.8, 0.95}) {
      const double chance = chance_of(quantile_ranks(count, p), count, p);
      EXPECT_GE(chance, 0.95 - 1e-12) << count << " " << p;
      if (count >= 100) {
        EXPECT_LE(chance, 0.97) << count << " " << p;
      }
    }
  }
  // Classical: of 9 numbers the median lies between the second and the eighth (96.1 %).
  EXPECT_EQ(quantile_ranks(9, 0.5).low, 2u);
  EXPECT_EQ(quantile_ranks(9, 0.5).high, 8u);
  EXPECT_FALSE(quantile_ranks(20, 0.95).high) << "twenty numbers do not bound P95 from above";
}

TEST(RankCorrelation, OfNumbersWorkedOutByHand) {
  const std::vector<double> x = {1, 2, 3, 4, 5};
  EXPECT_DOUBLE_EQ(rank_correlation(x, std::vector<double>{10, 20, 30, 40, 1e9}), 1);
  EXPECT_DOUBLE_EQ(rank_correlation(x, std::vector<double>{9, 8, 7, 6, -5}), -1);
  EXPECT_DOUBLE_EQ(rank_correlation(x, std::vector<double>{2, 1, 4, 3, 5}), 0.8);
  EXPECT_EQ(rank_correlation(x, std::vector<double>(5, 2.0)), 0);
  EXPECT_EQ(ranks_of(std::vector<double>{5, 1, 5, 0}), (std::vector<double>{3.5, 2, 3.5, 1}));
}

TEST(Pareto, IsWhatBruteForceFinds) {
  math::Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Costs> points(1 + random.index(12));
    for (Costs& each : points) {
      each = {static_cast<double>(random.index(6)), static_cast<double>(random.index(6))};
      if (random.index(8) == 0) each.first = kNever;
    }
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool beaten = !std::isfinite(points[i].first);
      for (const Costs& other : points) {
        beaten = beaten || (other.first <= points[i].first && other.second <= points[i].second &&
                            (other.first < points[i].first || other.second < points[i].second));
      }
      if (!beaten) expected.push_back(i);
    }
    std::vector<std::size_t> found = pareto_front(points);
    for (std::size_t i = 1; i < found.size(); ++i) {
      EXPECT_LE(points[found[i - 1]].first, points[found[i]].first);
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

TEST(QuantileDifference, SeesAShiftThatIsTheSameInAllPairs) {
  math::Random random(5);
  std::vector<double> a;
  for (int i = 0; i < 200; ++i) a.push_back(100 + 30 * random.normal());
  std::vector<double> b = a;
  for (double& each : b) each += 5;
  const auto interval = quantile_difference(a, b, 0.8);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->low, 5, 1e-9);
  EXPECT_NEAR(interval->high, 5, 1e-9);
  EXPECT_TRUE(quantile_difference(a, a, 0.5)->holds(0));
  b[3] = kNever;
  EXPECT_TRUE(quantile_difference(a, b, 0.5)) << "one that never ends is above the median";
  EXPECT_FALSE(
      quantile_difference(std::vector<double>(19, 1.0), std::vector<double>(19, 1.0), 0.5));
}

}  // namespace
}  // namespace rubicon::statistics
