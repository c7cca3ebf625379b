#include "src/motion/math/angles.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace rubicon::math {
namespace {

/// An unevaluated sum of two doubles, |low| at most half an ulp of `high`.
struct Double2 {
  double high = 0;
  double low = 0;
};

constexpr Double2 kRadiansPerDegree = {0.017453292519943295, 2.9486522708701687e-19};
constexpr Double2 kDegreesPerRadian = {57.295779513082323, -1.9878495670576283e-15};

/// atan(k / 16) in degrees, k = 0..16.
constexpr std::array<Double2, 17> kArcTangents = {{
    {0, 0},
    {3.5763343749973511, -4.2548397151964948e-17},
    {7.1250163489017977, -1.2948639595014213e-16},
    {10.619655276155134, 3.9353821206767933e-16},
    {14.036243467926479, -1.1785456382828569e-16},
    {17.354024636261322, 2.6293255782089668e-16},
    {20.556045219583464, 7.7357536433626208e-16},
    {23.629377730656817, -3.8572705379168432e-17},
    {26.56505117707799, -6.6734324949506593e-16},
    {29.357753542791272, 3.1832317134497578e-16},
    {32.005383208083494, 1.8761647814886433e-15},
    {34.5085229876684, 1.6654005518742188e-15},
    {36.86989764584402, 1.3346864989901319e-15},
    {39.093858886229498, 2.3358817436386549e-15},
    {41.185925165709648, -2.0942594695766676e-15},
    {43.152389734005403, 8.5029008270624822e-16},
    {45, 0},
}};

/// Beyond this many degrees (2^46 right angles) 90 k is no longer exact; then whole turns are
/// removed by fmod first, which is exact by definition but slow.
constexpr double kLargeDegrees = 6.0e15;

/// Splits a into two halves of 26 bits (Dekker 1971), so that products of halves are exact.
Double2 split(double a) {
  const double c = 134217729.0 * a;
  const double high = c - (c - a);
  return {high, a - high};
}

/// a * b without rounding (Dekker 1971); no fused multiply-add, whose presence differs between
/// processors.
Double2 exact_product(double a, double b) {
  const double p = a * b;
  const Double2 as = split(a);
  const Double2 bs = split(b);
  return {p, ((as.high * bs.high - p) + as.high * bs.low + as.low * bs.high) + as.low * bs.low};
}

/// a + b without rounding (Knuth).
Double2 exact_sum(double a, double b) {
  const double s = a + b;
  const double t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// Sine of x.high + x.low radians, |x| up to a little over pi/4: the Taylor series to x^17, whose
/// next term is below 1e-18 there; the leading term is added last, so the error stays little above
/// half an ulp. Summed in pairs, which the processor works out side by side.
double sine_kernel(Double2 x) {
  const double z = x.high * x.high;
  const double zz = z * z;
  const double low_pairs = (-1.0 / 6 + z * (1.0 / 120)) + zz * (-1.0 / 5040 + z * (1.0 / 362880));
  const double high_pairs = (-1.0 / 39916800 + z * (1.0 / 6227020800.0)) +
                            zz * (-1.0 / 1307674368000.0 + z * (1.0 / 355687428096000.0));
  const double series = low_pairs + zz * zz * high_pairs;
  return x.high + (x.high * z * series + x.low * (1 - 0.5 * z));
}

/// Cosine of x.high + x.low radians, |x| up to a little over pi/4: the Taylor series to x^18,
/// summed likewise.
double cosine_kernel(Double2 x) {
  const double z = x.high * x.high;
  const double zz = z * z;
  const double low_pairs =
      (1.0 / 24 + z * (-1.0 / 720)) + zz * (1.0 / 40320 + z * (-1.0 / 3628800));
  const double high_pairs = (1.0 / 479001600 + z * (-1.0 / 87178291200.0)) +
                            zz * (1.0 / 20922789888000.0 + z * (-1.0 / 6402373705728000.0));
  const double series = low_pairs + zz * zz * high_pairs;
  const double half = 0.5 * z;
  const double leading = 1 - half;
  return leading + (((1 - leading) - half) + (zz * series - x.high * x.low));
}

/// An angle as whole right angles and a rest in radians, the rest within a little over 45 degrees
/// of 0.
struct ReducedAngle {
  int quadrant = 0;  ///< 0..3
  Double2 rest;
};

ReducedAngle reduce(double degrees) {
  if (std::fabs(degrees) > kLargeDegrees) degrees = std::fmod(degrees, 360.0);
  const auto right_angles =
      static_cast<long long>(degrees * (1.0 / 90) + (degrees < 0 ? -0.5 : 0.5));
  // Exact: 90 k needs at most 53 bits, and the two operands are within a factor of two of each
  // other (or k is 0).
  const double rest = degrees - 90 * static_cast<double>(right_angles);
  Double2 radian = exact_product(rest, kRadiansPerDegree.high);
  radian.low += rest * kRadiansPerDegree.low;
  return {static_cast<int>(right_angles & 3), radian};
}

double sine_of_quadrant(int quadrant, Double2 rest) {
  switch (quadrant & 3) {
    case 0:
      return sine_kernel(rest);
    case 1:
      return cosine_kernel(rest);
    case 2:
      return -sine_kernel(rest);
    default:
      return -cosine_kernel(rest);
  }
}

/// atan(small / large) in degrees for 0 <= small <= large, large > 0: from the nearest k / 16 by
/// the addition theorem, the remaining |z| <= about 1/32 by the series of atan.
Double2 arc_tangent(double small, double large) {
  const int k = static_cast<int>(16 * (small / large) + 0.5);
  const double c = k / 16.0;
  const Double2 large_halves = split(large);
  const Double2 small_halves = split(small);
  const double numerator = (small - c * large_halves.high) - c * large_halves.low;
  const double denominator = large + c * small;
  const double denominator_low =
      ((large - denominator) + c * small_halves.high) + c * small_halves.low;
  const double z = numerator / denominator;
  const Double2 back = exact_product(z, denominator);
  const double z_low = (((numerator - back.high) - back.low) - z * denominator_low) / denominator;
  const double zz = z * z;
  const double correction =
      z_low + z * zz *
                  (-1.0 / 3 +
                   zz * (1.0 / 5 + zz * (-1.0 / 7 + zz * (1.0 / 9 + zz * (-1.0 / 11 + zz / 13)))));
  const Double2 main = exact_product(z, kDegreesPerRadian.high);
  const Double2 table = kArcTangents[static_cast<std::size_t>(k)];
  const Double2 sum = exact_sum(table.high, main.high);
  return {sum.high, sum.low + (main.low + table.low + z * kDegreesPerRadian.low +
                               correction * kDegreesPerRadian.high)};
}

}  // namespace

// Adding 0.0 turns -0 into 0, so that no "-0" reaches a file.
double sin_deg(double degrees) {
  if (!std::isfinite(degrees)) return std::numeric_limits<double>::quiet_NaN();
  const ReducedAngle angle = reduce(degrees);
  return sine_of_quadrant(angle.quadrant, angle.rest) + 0.0;
}

double cos_deg(double degrees) {
  if (!std::isfinite(degrees)) return std::numeric_limits<double>::quiet_NaN();
  const ReducedAngle angle = reduce(degrees);
  return sine_of_quadrant(angle.quadrant + 1, angle.rest) + 0.0;
}

SineCosine sine_cosine_deg(double degrees) {
  if (!std::isfinite(degrees)) {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  }
  const ReducedAngle angle = reduce(degrees);
  const double sine = sine_kernel(angle.rest);
  const double cosine = cosine_kernel(angle.rest);
  switch (angle.quadrant) {
    case 0:
      return {sine + 0.0, cosine + 0.0};
    case 1:
      return {cosine + 0.0, -sine + 0.0};
    case 2:
      return {-sine + 0.0, -cosine + 0.0};
    default:
      return {-cosine + 0.0, sine + 0.0};
  }
}

double atan2_deg(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  double width = std::fabs(x);
  double height = std::fabs(y);
  if (width == 0 && height == 0) return 0;
  if (std::isinf(width) || std::isinf(height)) {
    width = std::isinf(width) ? 1 : 0;
    height = std::isinf(height) ? 1 : 0;
  }
  const bool steep = height > width;
  double small = steep ? width : height;
  double large = steep ? height : width;
  // Keep the exact products inside the range of doubles; powers of two scale without rounding.
  if (large > 0x1p500) {
    small *= 0x1p-600;
    large *= 0x1p-600;
  } else if (large < 0x1p-500) {
    small *= 0x1p540;
    large *= 0x1p540;
  }
  Double2 angle = arc_tangent(small, large);
  if (steep) {
    const Double2 rest = exact_sum(90, -angle.high);
    angle = {rest.high, rest.low - angle.low};
  }
  if (x < 0) {
    const Double2 rest = exact_sum(180, -angle.high);
    angle = {rest.high, rest.low - angle.low};
  }
  const double magnitude = angle.high + angle.low;
  return y < 0 && magnitude < 180 ? -magnitude : magnitude;
}

}  // namespace rubicon::math
