#pragma once

#include <cstdint>

namespace rubicon::math {

/// Random numbers that are the same with every compiler, library and processor: SplitMix64 (Steele,
/// Lea, Flood, OOPSLA 2014) and distributions of our own, which call no function of the C library
/// that may differ.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits();
  /// In [0, 1): 53 bits.
  double uniform();
  double between(double least, double most) { return least + (most - least) * uniform(); }
  /// 0 to count - 1; count > 0.
  std::size_t index(std::size_t count);
  /// Of the standard normal distribution (Marsaglia's polar method).
  double normal();
  /// Of the gamma distribution of a shape >= 1, scale 1 (Marsaglia, Tsang, ACM TOMS 26(3), 2000).
  double gamma(double shape);
  /// Of the beta distribution; both shapes >= 1.
  double beta(double a, double b);

 private:
  std::uint64_t state_;
};

/// Natural logarithm of a positive finite value, and the exponential function, to about 1e-15: by
/// arithmetic alone.
double log_of(double x);
double exp_of(double x);

}  // namespace rubicon::math
