#include "src/motion/robot/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::robot {
namespace {

/// One operation rounds by at most half of this part of its result; a whole one is added outwards.
constexpr double kRounding = 0x1p-52;

/// sin_deg and cos_deg are within one ulp; two are added.
constexpr double kTrigonometricError = 0x1p-51;

Interval outward(double lower, double upper) {
  return {lower - kRounding * std::fabs(lower), upper + kRounding * std::fabs(upper)};
}

/// A product of bounds; an unbounded interval times an exact zero is zero.
double bound_product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

constexpr Interval kWholeLine = {-std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::infinity()};

/// Whether an angle that points as `peak` does lies inside the interval.
bool contains_peak(Interval degrees, double peak) {
  return math::first_equivalent_deg(peak, degrees.lower) <= degrees.upper;
}

/// A sine or cosine over an interval of degrees, from its values at the two ends and the place of a
/// peak.
Interval wave(Interval degrees, double a, double b, double peak) {
  if (!(degrees.upper - degrees.lower < math::kTurn_deg)) return {-1, 1};
  if (degrees.lower == degrees.upper && (a == 0 || a == 1 || a == -1)) return {a, a};
  // The rounded bounds of the interval may sit just beside a peak; there the error added below
  // covers the rest.
  const double upper = contains_peak(degrees, peak) ? 1 : std::max(a, b) + kTrigonometricError;
  const double lower = contains_peak(degrees, peak + math::kHalfTurn_deg)
                           ? -1
                           : std::min(a, b) - kTrigonometricError;
  return {std::max(lower, -1.0), std::min(upper, 1.0)};
}

Interval scaled(Interval a, double factor) { return a * point_interval(factor); }

constexpr double kRadiansPerDegree = math::kPi / 180.0;

}  // namespace

Interval point_interval(double value) { return {value, value}; }

Interval operator+(Interval a, Interval b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  return outward(a.lower + b.lower, a.upper + b.upper);
}

Interval operator-(Interval a) { return {-a.upper, -a.lower}; }

Interval operator-(Interval a, Interval b) { return a + (-b); }

Interval operator*(Interval a, Interval b) {
  if (is_zero(a) || is_zero(b)) return {0, 0};
  const double p = bound_product(a.lower, b.lower);
  const double q = bound_product(a.lower, b.upper);
  const double r = bound_product(a.upper, b.lower);
  const double s = bound_product(a.upper, b.upper);
  return outward(std::min(std::min(p, q), std::min(r, s)),
                 std::max(std::max(p, q), std::max(r, s)));
}

Interval operator/(Interval a, Interval b) {
  if (is_zero(a)) return {0, 0};
  if (!(b.lower > 0 || b.upper < 0)) return kWholeLine;
  return a * outward(1 / b.upper, 1 / b.lower);
}

Interval square(Interval a) {
  const double far = magnitude(a);
  const double near = a.lower > 0 ? a.lower : (a.upper < 0 ? -a.upper : 0);
  return outward(near * near, far * far);
}

bool is_zero(Interval a) { return a.lower == 0 && a.upper == 0; }

double magnitude(Interval a) { return std::max(std::fabs(a.lower), std::fabs(a.upper)); }

Enclosure constant_enclosure(double value) { return {point_interval(value), {}, {}}; }

Enclosure operator+(const Enclosure& a, const Enclosure& b) {
  return {a.value + b.value, a.first + b.first, a.second + b.second};
}

Enclosure operator-(const Enclosure& a) { return {-a.value, -a.first, -a.second}; }

Enclosure operator-(const Enclosure& a, const Enclosure& b) {
  return {a.value - b.value, a.first - b.first, a.second - b.second};
}

Enclosure operator*(const Enclosure& a, const Enclosure& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + scaled(a.first * b.first, 2) + a.value * b.second};
}

Enclosure operator/(const Enclosure& a, const Enclosure& b) {
  const Interval reciprocal = point_interval(1) / b.value;
  const Interval reciprocal_square = square(reciprocal);
  const Enclosure inverse = {
      reciprocal, -(b.first * reciprocal_square),
      scaled(square(b.first) * reciprocal_square * reciprocal, 2) - b.second * reciprocal_square};
  return a * inverse;
}

SineCosineEnclosure sine_cosine(const Enclosure& a) {
  const math::SineCosine begin = math::sine_cosine_deg(a.value.lower);
  const math::SineCosine end =
      a.value.lower == a.value.upper ? begin : math::sine_cosine_deg(a.value.upper);
  const Interval s = wave(a.value, begin.sine, end.sine, 90);
  const Interval c = wave(a.value, begin.cosine, end.cosine, 0);
  if (is_zero(a.first) && is_zero(a.second)) return {{s, {}, {}}, {c, {}, {}}};
  const Interval rate = scaled(a.first, kRadiansPerDegree);
  const Interval acceleration = scaled(a.second, kRadiansPerDegree);
  const Interval rate_squared = square(rate);
  return {{s, c * rate, c * acceleration - s * rate_squared},
          {c, -(s * rate), -(s * acceleration) - c * rate_squared}};
}

Enclosure sine(const Enclosure& a) { return sine_cosine(a).sine; }

Enclosure cosine(const Enclosure& a) { return sine_cosine(a).cosine; }

}  // namespace rubicon::robot
