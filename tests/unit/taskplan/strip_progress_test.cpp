#include "src/simulation/taskplan/strip_progress.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubicon::taskplan {
namespace {

constexpr std::int64_t kSec = 1'000'000'000;

class StripProgressTest : public ::testing::Test {
 protected:
  StripProgressTest() { strip_.begin(1, {0, 0}, {10, 0}); }
  void step(double from, double to, double begin, double end, double aside = 0) {
    strip_.add({from, aside}, {to, aside}, static_cast<std::int64_t>(begin * kSec),
               static_cast<std::int64_t>(end * kSec), laid_);
  }
  StripProgress strip_;
  std::vector<coverage::LaidStretch> laid_;
};

TEST_F(StripProgressTest, StepsAtOneSpeedAreOneStretch) {
  for (int i = 0; i < 20; ++i) step(0.5 * i, 0.5 * (i + 1), 5 * i, 5 * (i + 1), 0.01);
  ASSERT_EQ(laid_.size(), 1u);
  EXPECT_EQ(laid_[0].from.x, 0);
  EXPECT_EQ(laid_[0].to.x, 10);
  EXPECT_EQ(laid_[0].to.y, 0);
  EXPECT_EQ(laid_[0].end, 100 * kSec);
}

TEST_F(StripProgressTest, APauseBeginsAnotherStretch) {
  step(0, 4, 0, 40);
  step(4, 10, 1000, 1060);
  ASSERT_EQ(laid_.size(), 2u);
  EXPECT_EQ(laid_[1].from.x, 4);
  EXPECT_EQ(laid_[1].begin, 1000 * kSec);
}

TEST_F(StripProgressTest, WhatWasPassedBeforeCountsNoMore) {
  step(0, 6, 0, 60);
  step(6, 2, 60, 70);    // back
  step(2, 8, 200, 260);  // at 6 again after 240 s
  step(8, 8, 260, 300);  // stands
  ASSERT_EQ(laid_.size(), 2u);
  EXPECT_EQ(laid_[0].end, 60 * kSec);
  EXPECT_DOUBLE_EQ(laid_[1].from.x, 6);
  EXPECT_EQ(laid_[1].begin, 240 * kSec);
  EXPECT_EQ(laid_[1].end, 260 * kSec);
}

TEST_F(StripProgressTest, SpeedsThatDifferAreToldToHalfASecond) {
  // Slower and slower: every place is laid when it was, to half a second, in few stretches.
  double now = 0;
  std::vector<double> when{0};
  for (int i = 0; i < 100; ++i) {
    const double after = now + 1 + 0.02 * i;
    step(0.1 * i, 0.1 * (i + 1), now, after);
    when.push_back(now = after);
  }
  EXPECT_GT(laid_.size(), 1u);
  EXPECT_LT(laid_.size(), 20u);
  for (int i = 1; i <= 100; ++i) {
    const double x = 0.1 * i;
    for (const coverage::LaidStretch& each : laid_) {
      if (x < each.from.x - 1e-9 || x > each.to.x + 1e-9) continue;
      const double share = (x - each.from.x) / (each.to.x - each.from.x);
      const double told =
          static_cast<double>(each.begin) + share * static_cast<double>(each.end - each.begin);
      EXPECT_NEAR(told / kSec, when[static_cast<std::size_t>(i)], 0.5 + 1e-6) << i;
    }
  }
}

}  // namespace
}  // namespace rubicon::taskplan
