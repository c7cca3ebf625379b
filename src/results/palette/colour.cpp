#include "src/results/palette/colour.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace rubicon::palette {

namespace {

/// The fifth root of a number in 0..1 by Newton's method: the C library's pow differs between
/// machines.
double fifth_root(double value) {
  double root = 1;
  for (int i = 0; i < 60; ++i) root -= (root - value / (root * root * root * root)) / 5;
  return root;
}

/// IEC 61966-2-1: x^2.4 is the fifth root of x^12.
double linear(double share) {
  if (share <= 0.04045) return share / 12.92;
  const double x = (share + 0.055) / 1.055;
  return x * x * fifth_root(x * x);
}

}  // namespace

std::array<double, 3> linear_rgb(std::string_view colour) { return linear_rgb(colour, 0); }

std::array<double, 3> linear_rgb(std::string_view colour, double share) {
  unsigned value = 0;
  const char* end = colour.data() + colour.size();
  if (colour.size() != 7 || colour[0] != '#' ||
      std::from_chars(colour.data() + 1, end, value, 16).ptr != end) {
    throw std::invalid_argument("expected a colour as #rrggbb, found " + std::string(colour));
  }
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double sRgb = static_cast<double>((value >> (16 - 8 * i)) & 255) / 255;
    const double mixed = sRgb + std::fabs(share) * ((share > 0 ? 1 : 0) - sRgb);
    result[i] = linear(mixed);
  }
  return result;
}

}  // namespace rubicon::palette
