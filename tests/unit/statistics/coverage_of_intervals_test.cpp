// The 95 % intervals of a study, held against answers that are known in closed form: 2,000 times
// the runs of a plan, each time with a seed of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "src/simulation/sampling/duration_law.hpp"
#include "src/studies/statistics/mean.hpp"
#include "src/studies/statistics/quantile.hpp"
#include "tests/support/random_cases.hpp"

namespace rubicon::statistics {
namespace {

using sampling::DurationLaw;
using sampling::Law;

constexpr int kRepetitions = test::cases(2000);
/// Of 2,000 repetitions 95 % +- 2 %; of the tenth that sanitizers make, three times as far.
constexpr double kTolerance = test::kFewerCases == 1 ? 0.02 : 0.06;

/// Process times of `runs` runs of three tasks in a row.
std::vector<double> three_in_a_row(int seed, int runs) {
  static const DurationLaw laws[] = {{Law::pert, {3600, 7200, 18000}},
                                     {Law::triangular, {0, 600, 7200}},
                                     {Law::exponential, {3000}}};
  static const char* const places[] = {"a.takes", "b.takes", "c.takes"};
  std::vector<double> times;
  for (int run = 0; run < runs; ++run) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      sum += draw(laws[i],
                  {static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(run), places[i]});
    }
    times.push_back(sum);
  }
  return times;
}

TEST(IntervalOfTheMean, HoldsTheMeanOfThreeTasksInARow) {
  const double mean = (3600 + 4 * 7200 + 18000) / 6.0 + (0 + 600 + 7200) / 3.0 + 3000;
  int held = 0;
  for (int seed = 1; seed <= kRepetitions; ++seed) {
    if (mean_of(three_in_a_row(seed, 100)).interval->holds(mean)) ++held;
  }
  RecordProperty("held", held);
  EXPECT_NEAR(static_cast<double>(held) / kRepetitions, 0.95, kTolerance);
}

TEST(IntervalOfAQuantile, HoldsThatOfTwoTasksSideBySide) {
  // The later of two exponential tasks: P(T <= t) = (1 - exp(-t / m))^2.
  const DurationLaw law{Law::exponential, {3600}};
  for (const double p : {0.5, 0.8, 0.95}) {
    const double known = -3600 * std::log(1 - std::sqrt(p));
    int held = 0;
    for (int seed = 1; seed <= kRepetitions; ++seed) {
      std::vector<double> times;
      for (std::uint64_t run = 0; run < 200; ++run) {
        const auto at = static_cast<std::uint64_t>(seed);
        times.push_back(std::max(draw(law, {at, run, "a.takes"}), draw(law, {at, run, "b.takes"})));
      }
      std::sort(times.begin(), times.end());
      if (quantile_interval(times, p).holds(known)) ++held;
    }
    RecordProperty("held_" + std::to_string(p), held);
    EXPECT_NEAR(static_cast<double>(held) / kRepetitions, 0.95, kTolerance) << p;
  }
}

TEST(IntervalOfAQuantile, StillHoldsWhereItsWidthEndedTheRuns) {
  // As a study does: after every 50 runs, until the interval of P80 is narrower than asked.
  const DurationLaw law{Law::exponential, {3600}};
  const double known = -3600 * std::log(1 - 0.8);
  int held = 0;
  double runs = 0;
  for (int seed = 1; seed <= kRepetitions; ++seed) {
    std::vector<double> times;
    Interval interval;
    do {
      for (int i = 0; i < 50; ++i) {
        times.push_back(draw(law, {static_cast<std::uint64_t>(seed), times.size(), "a.takes"}));
      }
      std::vector<double> sorted = times;
      std::sort(sorted.begin(), sorted.end());
      interval = quantile_interval(sorted, 0.8);
    } while (interval.width() > 1800 && times.size() < 1000);
    runs += static_cast<double>(times.size());
    if (interval.holds(known)) ++held;
  }
  RecordProperty("held", held);
  EXPECT_GE(static_cast<double>(held) / kRepetitions, 0.92 - (kTolerance - 0.02));
  EXPECT_GT(runs / kRepetitions, 100) << "the rule should matter";
  EXPECT_LT(runs / kRepetitions, 900);
}

}  // namespace
}  // namespace rubicon::statistics
