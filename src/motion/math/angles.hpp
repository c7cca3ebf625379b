#pragma once

namespace rubicon::math {

/// Sine of an angle in degrees. Exact at multiples of 90; the same bits on every machine (own
/// polynomial, no FMA, no library call). NaN for a value that is not finite.
double sin_deg(double degrees);

/// Cosine of an angle in degrees. Exact at multiples of 90; the same bits on every machine.
double cos_deg(double degrees);

struct SineCosine {
  double sine = 0;
  double cosine = 0;
};

/// sin_deg and cos_deg of one angle, bit for bit, at little more than the price of one.
SineCosine sine_cosine_deg(double degrees);

/// Angle of the vector (x, y) in degrees, in (-180, 180]; exact on the axes and the diagonals;
/// atan2_deg(0, 0) is 0.
double atan2_deg(double y, double x);

inline constexpr double kPi = 3.14159265358979323846;

/// Degrees to radians and back. Radians exist only from kinematics on (poses, collision).
inline constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
inline constexpr double degrees(double radians) { return radians * (180.0 / kPi); }

}  // namespace rubicon::math
