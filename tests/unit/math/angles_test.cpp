#include "src/motion/math/angles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace rubicon::math {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Angles, SineAndCosineAreExactAtMultiplesOfNinety) {
  for (const double turns :
       {0.0, 360.0, -360.0, 3600.0, 360.0 * 1e9, -360.0 * 1e12, 360.0 * 4194304 * 1048576}) {
    EXPECT_EQ(sin_deg(turns), 0) << turns;
    EXPECT_EQ(cos_deg(turns), 1) << turns;
    EXPECT_EQ(sin_deg(turns + 90), 1) << turns;
    EXPECT_EQ(cos_deg(turns + 90), 0) << turns;
    EXPECT_EQ(sin_deg(turns + 180), 0) << turns;
    EXPECT_EQ(cos_deg(turns + 180), -1) << turns;
    EXPECT_EQ(sin_deg(turns - 90), -1) << turns;
    EXPECT_EQ(cos_deg(turns - 90), 0) << turns;
  }
}

TEST(Angles, ZeroIsNeverNegative) {
  for (const double degrees : {-0.0, 180.0, -180.0, 360.0, -360.0})
    EXPECT_FALSE(std::signbit(sin_deg(degrees)));
  for (const double degrees : {90.0, -90.0, 270.0, -270.0})
    EXPECT_FALSE(std::signbit(cos_deg(degrees)));
}

TEST(Angles, HalvesAreExact) {
  for (const double degrees : {30.0, 150.0, 390.0, -210.0})
    EXPECT_EQ(sin_deg(degrees), 0.5) << degrees;
  for (const double degrees : {-30.0, -150.0, 210.0, 330.0})
    EXPECT_EQ(sin_deg(degrees), -0.5) << degrees;
  for (const double degrees : {60.0, -60.0, 300.0, 420.0})
    EXPECT_EQ(cos_deg(degrees), 0.5) << degrees;
  for (const double degrees : {120.0, -120.0, 240.0}) EXPECT_EQ(cos_deg(degrees), -0.5) << degrees;
}

TEST(Angles, HugeAnglesAreReducedExactly) {
  // 1e15 = 360 * 2777777777777 + 280; 1e22 is a double and is 280 above a multiple of 360 as well.
  EXPECT_EQ(sin_deg(1e15), sin_deg(280));
  EXPECT_EQ(cos_deg(1e15), cos_deg(280));
  EXPECT_EQ(sin_deg(-1e15), sin_deg(-280));
  EXPECT_EQ(sin_deg(1e22), sin_deg(280));
  EXPECT_TRUE(std::isfinite(sin_deg(std::numeric_limits<double>::max())));
}

TEST(Angles, NotFiniteGivesNan) {
  for (const double value : {kInfinity, -kInfinity, kNan}) {
    EXPECT_TRUE(std::isnan(sin_deg(value)));
    EXPECT_TRUE(std::isnan(cos_deg(value)));
  }
  EXPECT_TRUE(std::isnan(atan2_deg(kNan, 1)));
}

TEST(Angles, ArcTangentIsExactOnAxesAndDiagonals) {
  for (const double size : {1.0, 0.1, 3.7e-300, 5e-324, 1.7e308, 12.34}) {
    EXPECT_EQ(atan2_deg(0, size), 0) << size;
    EXPECT_EQ(atan2_deg(size, size), 45) << size;
    EXPECT_EQ(atan2_deg(size, 0), 90) << size;
    EXPECT_EQ(atan2_deg(size, -size), 135) << size;
    EXPECT_EQ(atan2_deg(0, -size), 180) << size;
    EXPECT_EQ(atan2_deg(-0.0, -size), 180) << size;
    EXPECT_EQ(atan2_deg(-size, -size), -135) << size;
    EXPECT_EQ(atan2_deg(-size, 0), -90) << size;
    EXPECT_EQ(atan2_deg(-size, size), -45) << size;
  }
  EXPECT_EQ(atan2_deg(0, 0), 0);
  EXPECT_EQ(atan2_deg(0, -0.0), 0);
  EXPECT_EQ(atan2_deg(kInfinity, 3), 90);
  EXPECT_EQ(atan2_deg(-kInfinity, kInfinity), -45);
}

TEST(Angles, ArcTangentStaysAboveMinusHalfATurn) { EXPECT_EQ(atan2_deg(-1e-300, -1), 180); }

TEST(Angles, SineAndCosineTogetherAreTheSameBits) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> angle(-1000, 1000);
  for (int i = 0; i < 20000; ++i) {
    const double degrees = i < 100 ? 45.0 * i - 2000 : angle(random);
    const SineCosine both = sine_cosine_deg(degrees);
    EXPECT_EQ(both.sine, sin_deg(degrees));
    EXPECT_EQ(both.cosine, cos_deg(degrees));
    EXPECT_EQ(std::signbit(both.sine), std::signbit(sin_deg(degrees)));
    EXPECT_EQ(std::signbit(both.cosine), std::signbit(cos_deg(degrees)));
  }
  EXPECT_TRUE(std::isnan(sine_cosine_deg(kInfinity).sine));
}

TEST(Angles, ArcTangentUndoesSineAndCosine) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> angle(-180, 180);
  for (int i = 0; i < 20000; ++i) {
    const double degrees = angle(random);
    EXPECT_NEAR(atan2_deg(sin_deg(degrees), cos_deg(degrees)), degrees, 3e-14);
  }
}

}  // namespace
}  // namespace rubicon::math
