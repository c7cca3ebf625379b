#include "src/motion/math/random.hpp"

#include <cmath>

namespace rubicon::math {

namespace {

constexpr double kLn2 = 0.693147180559945309417;

}  // namespace

double log_of(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // in [0.5, 1)
  if (m < 0.70710678118654752) {
    m *= 2;
    --exponent;
  }
  // ln m = 2 artanh((m - 1) / (m + 1)); |z| < 0.172
  const double z = (m - 1) / (m + 1);
  const double z2 = z * z;
  double sum = 0;
  for (int k = 21; k >= 1; k -= 2) sum = sum * z2 + 1.0 / k;
  return 2 * z * sum + exponent * kLn2;
}

double exp_of(double x) {
  const double turns = std::floor(x / kLn2 + 0.5);
  if (turns < -1000) return 0;
  const double r = x - turns * kLn2;  // |r| < 0.35
  double sum = 1;
  for (int k = 16; k >= 1; --k) sum = 1 + sum * r / k;
  return std::ldexp(sum, static_cast<int>(turns));
}

std::uint64_t Random::bits() {
  state_ += 0x9e3779b97f4a7c15ull;
  std::uint64_t x = state_;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

double Random::uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

std::size_t Random::index(std::size_t count) {
  const auto i = static_cast<std::size_t>(uniform() * static_cast<double>(count));
  return i < count ? i : count - 1;
}

double Random::normal() {
  while (true) {
    const double u = between(-1, 1);
    const double v = between(-1, 1);
    const double s = u * u + v * v;
    if (s > 0 && s < 1) return u * std::sqrt(-2 * log_of(s) / s);
  }
}

double Random::gamma(double shape) {
  const double d = shape - 1.0 / 3;
  const double c = 1 / std::sqrt(9 * d);
  while (true) {
    const double x = normal();
    const double root = 1 + c * x;
    const double u = uniform();
    if (root <= 0 || u <= 0) continue;
    const double v = root * root * root;
    if (log_of(u) < 0.5 * x * x + d - d * v + d * log_of(v)) return d * v;
  }
}

double Random::beta(double a, double b) {
  const double x = gamma(a);
  return x / (x + gamma(b));
}

}  // namespace rubicon::math
