#include <gtest/gtest.h>
#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "src/motion/math/angles.hpp"

namespace rubicon::math {
namespace {

/// A number of 400 bits; enough that the errors measured below are those of the functions under
/// test alone.
class Big {
 public:
  Big() { mpfr_init2(value_, 400); }
  explicit Big(double value) : Big() { mpfr_set_d(value_, value, MPFR_RNDN); }
  ~Big() { mpfr_clear(value_); }
  Big(const Big&) = delete;
  Big& operator=(const Big&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// |computed - exact| in units of the last place of the exact value.
double error_in_ulps(double computed, Big& exact) {
  const double near = std::fabs(mpfr_get_d(exact.get(), MPFR_RNDN));
  const double ulp = std::nextafter(near, INFINITY) - near;
  Big difference;
  mpfr_sub_d(difference.get(), exact.get(), computed, MPFR_RNDN);
  return std::fabs(mpfr_get_d(difference.get(), MPFR_RNDN)) / ulp;
}

double sine_error(double degrees) {
  Big radian(degrees), pi;
  mpfr_fmod_ui(radian.get(), radian.get(), 360, MPFR_RNDN);
  mpfr_const_pi(pi.get(), MPFR_RNDN);
  mpfr_mul(radian.get(), radian.get(), pi.get(), MPFR_RNDN);
  mpfr_div_ui(radian.get(), radian.get(), 180, MPFR_RNDN);
  Big exact;
  mpfr_sin(exact.get(), radian.get(), MPFR_RNDN);
  if (std::fmod(degrees, 180.0) == 0) return sin_deg(degrees) == 0 ? 0 : INFINITY;
  return error_in_ulps(sin_deg(degrees), exact);
}

double cosine_error(double degrees) {
  Big radian(degrees), pi;
  mpfr_fmod_ui(radian.get(), radian.get(), 360, MPFR_RNDN);
  mpfr_const_pi(pi.get(), MPFR_RNDN);
  mpfr_mul(radian.get(), radian.get(), pi.get(), MPFR_RNDN);
  mpfr_div_ui(radian.get(), radian.get(), 180, MPFR_RNDN);
  Big exact;
  mpfr_cos(exact.get(), radian.get(), MPFR_RNDN);
  if (std::fabs(std::fmod(degrees, 180.0)) == 90) return cos_deg(degrees) == 0 ? 0 : INFINITY;
  return error_in_ulps(cos_deg(degrees), exact);
}

double arc_tangent_error(double y, double x) {
  Big by(y), bx(x), exact, pi;
  mpfr_atan2(exact.get(), by.get(), bx.get(), MPFR_RNDN);
  mpfr_const_pi(pi.get(), MPFR_RNDN);
  mpfr_mul_ui(exact.get(), exact.get(), 180, MPFR_RNDN);
  mpfr_div(exact.get(), exact.get(), pi.get(), MPFR_RNDN);
  return error_in_ulps(atan2_deg(y, x), exact);
}

constexpr int kCases = 200000;

/// Errors stay this little above the unavoidable half ulp.
constexpr double kMostUlps = 0.8;

TEST(AnglesOracle, SineAndCosineOverAFewTurns) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-800, 800);
  double worst = 0;
  for (int i = 0; i < kCases; ++i) {
    const double degrees = angle(random);
    worst = std::max({worst, sine_error(degrees), cosine_error(degrees)});
  }
  RecordProperty("worst_ulps", std::to_string(worst));
  EXPECT_LT(worst, kMostUlps);
}

TEST(AnglesOracle, SineAndCosineOfHugeAngles) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(2, 300);
  double worst = 0;
  for (int i = 0; i < kCases / 10; ++i) {
    const double degrees = std::pow(10.0, exponent(random));
    worst = std::max({worst, sine_error(degrees), cosine_error(degrees), sine_error(-degrees)});
  }
  for (const double degrees :
       {1e15, 1e15 + 30, 6.0e15, 6.0e15 + 1, 6.3e15, 9007199254740991.0, 1e22}) {
    worst = std::max({worst, sine_error(degrees), cosine_error(degrees)});
  }
  EXPECT_LT(worst, kMostUlps);
}

TEST(AnglesOracle, SineAndCosineBesideTheSeamsOfTheReduction) {
  double worst = 0;
  for (int k = -40; k <= 40; ++k) {
    for (int side = -200; side <= 200; ++side) {
      const double degrees = 45.0 * k + side * 1e-13;
      worst = std::max({worst, sine_error(degrees), cosine_error(degrees)});
    }
  }
  for (double tiny = 1; tiny > 1e-280; tiny /= 7) worst = std::max(worst, sine_error(tiny));
  EXPECT_LT(worst, kMostUlps);
}

TEST(AnglesOracle, ArcTangentInAllQuadrants) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-100, 100);
  std::uniform_real_distribution<double> exponent(-150, 150);
  double worst = 0;
  for (int i = 0; i < kCases; ++i) {
    worst = std::max(worst, arc_tangent_error(coordinate(random), coordinate(random)));
    const double x = coordinate(random) * std::pow(10.0, exponent(random));
    const double y = x * coordinate(random) * std::pow(10.0, exponent(random) / 20);
    worst = std::max(worst, arc_tangent_error(y, x));
  }
  RecordProperty("worst_ulps", std::to_string(worst));
  EXPECT_LT(worst, kMostUlps);
}

}  // namespace
}  // namespace rubicon::math
