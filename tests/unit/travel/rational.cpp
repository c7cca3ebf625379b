#include "tests/unit/travel/rational.hpp"

#include <cmath>
#include <utility>

namespace rubicon::travel {

BigInt::BigInt(std::int64_t value) : negative_(value < 0) {
  auto size = static_cast<std::uint64_t>(value);
  if (negative_) size = 0 - size;
  for (; size != 0; size >>= 32) digits_.push_back(static_cast<std::uint32_t>(size));
}

void BigInt::trim() {
  while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
  if (digits_.empty()) negative_ = false;
}

int BigInt::compare_sizes(const BigInt& a, const BigInt& b) {
  if (a.digits_.size() != b.digits_.size()) return a.digits_.size() < b.digits_.size() ? -1 : 1;
  for (std::size_t i = a.digits_.size(); i-- > 0;) {
    if (a.digits_[i] != b.digits_[i]) return a.digits_[i] < b.digits_[i] ? -1 : 1;
  }
  return 0;
}

BigInt BigInt::sum(const BigInt& a, const BigInt& b, bool subtract) {
  const bool b_negative = b.negative_ != subtract;
  BigInt result;
  if (a.negative_ == b_negative) {
    const std::size_t size = std::max(a.digits_.size(), b.digits_.size());
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < size || carry != 0; ++i) {
      if (i < a.digits_.size()) carry += a.digits_[i];
      if (i < b.digits_.size()) carry += b.digits_[i];
      result.digits_.push_back(static_cast<std::uint32_t>(carry));
      carry >>= 32;
    }
    result.negative_ = a.negative_;
  } else {
    const bool a_larger = compare_sizes(a, b) >= 0;
    const BigInt& large = a_larger ? a : b;
    const BigInt& small = a_larger ? b : a;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < large.digits_.size(); ++i) {
      std::int64_t digit = static_cast<std::int64_t>(large.digits_[i]) + borrow;
      if (i < small.digits_.size()) digit -= small.digits_[i];
      borrow = digit < 0 ? -1 : 0;
      if (digit < 0) digit += std::int64_t{1} << 32;
      result.digits_.push_back(static_cast<std::uint32_t>(digit));
    }
    result.negative_ = a_larger ? a.negative_ : b_negative;
  }
  result.trim();
  return result;
}

BigInt operator+(const BigInt& a, const BigInt& b) { return BigInt::sum(a, b, false); }
BigInt operator-(const BigInt& a, const BigInt& b) { return BigInt::sum(a, b, true); }

BigInt operator*(const BigInt& a, const BigInt& b) {
  BigInt result;
  result.digits_.assign(a.digits_.size() + b.digits_.size(), 0);
  for (std::size_t i = 0; i < a.digits_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < b.digits_.size(); ++j) {
      carry += static_cast<std::uint64_t>(a.digits_[i]) * b.digits_[j] + result.digits_[i + j];
      result.digits_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    result.digits_[i + b.digits_.size()] = static_cast<std::uint32_t>(carry);
  }
  result.negative_ = a.negative_ != b.negative_;
  result.trim();
  return result;
}

double BigInt::mantissa(int& exponent) const {
  double value = 0;
  const std::size_t size = digits_.size();
  const std::size_t used = size < 4 ? size : 4;
  for (std::size_t i = 0; i < used; ++i) value = value * 4294967296.0 + digits_[size - 1 - i];
  exponent = static_cast<int>(32 * (size - used));
  return negative_ ? -value : value;
}

std::string BigInt::hex() const {
  std::string text;
  for (std::size_t i = 0; i < digits_.size() * 8; ++i) {
    const std::uint32_t nibble = (digits_[i / 8] >> (4 * (i % 8))) & 15;
    text.insert(text.begin(), "0123456789abcdef"[nibble]);
  }
  while (text.size() > 1 && text.front() == '0') text.erase(text.begin());
  return (negative_ ? "-" : "") + (text.empty() ? "0" : text);
}

Rational::Rational(BigInt numerator, BigInt denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
  if (denominator_.sign() < 0) {
    numerator_ = BigInt(0) - numerator_;
    denominator_ = BigInt(0) - denominator_;
  }
}

Rational operator+(const Rational& a, const Rational& b) {
  return {a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_,
          a.denominator_ * b.denominator_};
}
Rational operator-(const Rational& a, const Rational& b) {
  return {a.numerator_ * b.denominator_ - b.numerator_ * a.denominator_,
          a.denominator_ * b.denominator_};
}
Rational operator*(const Rational& a, const Rational& b) {
  return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
}
Rational operator/(const Rational& a, const Rational& b) {
  return {a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
}

double Rational::value() const {
  int above = 0;
  int below = 0;
  const double numerator = numerator_.mantissa(above);
  const double denominator = denominator_.mantissa(below);
  return std::ldexp(numerator / denominator, above - below);
}

}  // namespace rubicon::travel
