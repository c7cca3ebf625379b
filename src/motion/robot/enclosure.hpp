#pragma once

#include "src/motion/robot/formula.hpp"

namespace rubicon::robot {

// Interval arithmetic with bounds rounded outwards, and the same for a value with its first two
// derivatives in s. Exact zeros stay exact, so that "does not change" and "changes linearly" can be
// read off a result.

Interval point_interval(double value);
Interval operator+(Interval a, Interval b);
Interval operator-(Interval a, Interval b);
Interval operator-(Interval a);
Interval operator*(Interval a, Interval b);
/// 0 * infinity is 0; a divisor that contains 0 gives the whole line.
Interval operator/(Interval a, Interval b);
Interval square(Interval a);
/// Both bounds 0.
bool is_zero(Interval a);
/// Largest absolute value in the interval.
double magnitude(Interval a);

Enclosure constant_enclosure(double value);
Enclosure operator+(const Enclosure& a, const Enclosure& b);
Enclosure operator-(const Enclosure& a, const Enclosure& b);
Enclosure operator-(const Enclosure& a);
Enclosure operator*(const Enclosure& a, const Enclosure& b);
Enclosure operator/(const Enclosure& a, const Enclosure& b);

struct SineCosineEnclosure {
  Enclosure sine;
  Enclosure cosine;
};

/// Sine and cosine of an angle in degrees.
SineCosineEnclosure sine_cosine(const Enclosure& a);
Enclosure sine(const Enclosure& a);
Enclosure cosine(const Enclosure& a);

}  // namespace rubicon::robot
