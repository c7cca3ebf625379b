#include "src/simulation/sampling/duration_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rubicon::sampling {
namespace {

struct Moments {
  double mean = 0;
  double deviation = 0;
  double least = 1e300;
  double most = -1e300;
};

Moments moments_of(const DurationLaw& law, int draws) {
  Moments moments;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < draws; ++i) {
    const double drawn = draw(law, {11, static_cast<std::uint64_t>(i), "task.takes"});
    sum += drawn;
    squares += drawn * drawn;
    moments.least = std::min(moments.least, drawn);
    moments.most = std::max(moments.most, drawn);
  }
  moments.mean = sum / draws;
  moments.deviation = std::sqrt(squares / draws - moments.mean * moments.mean);
  return moments;
}

TEST(DurationLaw, HasItsMeanAndDeviation) {
  struct Case {
    DurationLaw law;
    double mean;
    double deviation;
  };
  const Case cases[] = {
      {{Law::uniform, {60, 180}}, 120, 120 / std::sqrt(12.0)},
      {{Law::triangular, {60, 120, 300}},
       160,
       std::sqrt((60. * 60 + 120. * 120 + 300. * 300 - 60 * 120 - 60 * 300 - 120 * 300) / 18)},
      {{Law::pert, {0, 60, 240}}, 80, 240 * std::sqrt(2. * 4 / (36 * 7.))},
      {{Law::normal, {100, 10}}, 100, 10},
      {{Law::lognormal, {100, 50}}, 100, 50},
      {{Law::gamma, {100, 50}}, 100, 50},
      {{Law::gamma, {100, 150}}, 100, 150},
      {{Law::exponential, {100}}, 100, 100},
  };
  constexpr int kDraws = 200'000;
  for (const Case& each : cases) {
    SCOPED_TRACE(info_of(each.law.law).name);
    EXPECT_EQ(each.law.fault(), "");
    EXPECT_NEAR(each.law.mean(), each.mean, 1e-9);
    const Moments moments = moments_of(each.law, kDraws);
    // Four standard errors.
    EXPECT_NEAR(moments.mean, each.mean, 4 * each.deviation / std::sqrt(kDraws));
    EXPECT_NEAR(moments.deviation, each.deviation, 0.02 * each.deviation);
    EXPECT_GE(moments.least, each.law.least());
    EXPECT_LE(moments.most, each.law.most());
  }
}

TEST(DurationLaw, ADrawIsAFunctionOfItsPlace) {
  const DurationLaw law{Law::lognormal, {100, 50}};
  const double drawn = draw(law, {1, 0, "set_3.hook"});
  EXPECT_EQ(draw(law, {1, 0, "set_3.hook"}), drawn);
  EXPECT_NE(draw(law, {1, 0, "set_4.hook"}), drawn);
  EXPECT_NE(draw(law, {1, 1, "set_3.hook"}), drawn);
  EXPECT_NE(draw(law, {2, 0, "set_3.hook"}), drawn);
}

TEST(DurationLaw, NeighboursAreIndependent) {
  const DurationLaw law{Law::uniform, {0, 1}};
  constexpr int kRuns = 20'000;
  double by_run = 0;
  double by_name = 0;
  for (int i = 0; i < kRuns; ++i) {
    const auto run = static_cast<std::uint64_t>(i);
    const double here = draw(law, {1, run, "a_1.takes"}) - 0.5;
    by_run += here * (draw(law, {1, run + 1, "a_1.takes"}) - 0.5);
    by_name += here * (draw(law, {1, run, "a_2.takes"}) - 0.5);
  }
  // The correlation has a standard deviation of 1 / sqrt(n).
  EXPECT_LT(std::fabs(12 * by_run / kRuns), 4 / std::sqrt(kRuns));
  EXPECT_LT(std::fabs(12 * by_name / kRuns), 4 / std::sqrt(kRuns));
}

TEST(DurationLaw, SaysWhatIsWrong) {
  EXPECT_EQ((DurationLaw{Law::triangular, {1, 2}}.fault()),
            "triangular takes 3 values (low, likely, high), found 2");
  EXPECT_EQ((DurationLaw{Law::exponential, {1, 2}}.fault()),
            "exponential takes 1 value (mean), found 2");
  EXPECT_EQ((DurationLaw{Law::pert, {1, 3, 2}}.fault()),
            "the high value is below the likely value");
  EXPECT_EQ((DurationLaw{Law::uniform, {-1, 3}}.fault()), "the low value is below 0");
  EXPECT_EQ((DurationLaw{Law::gamma, {1, 0}}.fault()), "the deviation is 0");
  EXPECT_EQ((DurationLaw{Law::normal, {1, 2}}.fault()),
            "the deviation is larger than the mean: take lognormal or gamma");
}

}  // namespace
}  // namespace rubicon::sampling
