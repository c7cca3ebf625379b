#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rubicon::travel {

/// A whole number of any size: the oracle's, made to be seen through and not to be fast.
class BigInt {
 public:
  BigInt(std::int64_t value = 0);  // NOLINT: a number

  friend BigInt operator+(const BigInt& a, const BigInt& b);
  friend BigInt operator-(const BigInt& a, const BigInt& b);
  friend BigInt operator*(const BigInt& a, const BigInt& b);
  int sign() const { return digits_.empty() ? 0 : negative_ ? -1 : 1; }
  /// The value is the first times 2 to the second.
  double mantissa(int& exponent) const;
  std::string hex() const;

 private:
  static int compare_sizes(const BigInt& a, const BigInt& b);
  static BigInt sum(const BigInt& a, const BigInt& b, bool subtract);
  void trim();

  bool negative_ = false;
  std::vector<std::uint32_t> digits_;  ///< base 2^32, lowest first, no leading zeros
};

/// A fraction, exactly; never shortened.
class Rational {
 public:
  Rational(std::int64_t value = 0) : numerator_(value), denominator_(1) {}  // NOLINT: a number
  Rational(BigInt numerator, BigInt denominator);

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  int sign() const { return numerator_.sign(); }
  double value() const;

  friend bool operator==(const Rational& a, const Rational& b) { return (a - b).sign() == 0; }
  friend bool operator<(const Rational& a, const Rational& b) { return (a - b).sign() < 0; }

 private:
  BigInt numerator_;
  BigInt denominator_;  ///< positive
};

}  // namespace rubicon::travel
