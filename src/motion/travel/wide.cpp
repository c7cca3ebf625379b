#include "src/motion/travel/wide.hpp"

namespace rubicon::travel {

Wide::Wide(Int128 value) {
  const auto bits = static_cast<UInt128>(value);
  words_[0] = static_cast<std::uint64_t>(bits);
  words_[1] = static_cast<std::uint64_t>(bits >> 64);
  for (std::size_t i = 2; i < kWords; ++i) words_[i] = value < 0 ? ~std::uint64_t{0} : 0;
}

Wide operator+(const Wide& a, const Wide& b) {
  Wide sum;
  UInt128 carry = 0;
  for (std::size_t i = 0; i < Wide::kWords; ++i) {
    carry += static_cast<UInt128>(a.words_[i]) + b.words_[i];
    sum.words_[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  return sum;
}

Wide operator-(const Wide& a, const Wide& b) {
  Wide complement;
  for (std::size_t i = 0; i < Wide::kWords; ++i) complement.words_[i] = ~b.words_[i];
  return a + complement + Wide(1);
}

Wide operator*(const Wide& a, const Wide& b) {
  Wide product;
  for (std::size_t i = 0; i < Wide::kWords; ++i) {
    UInt128 carry = 0;
    for (std::size_t j = 0; i + j < Wide::kWords; ++j) {
      carry += static_cast<UInt128>(a.words_[i]) * b.words_[j] + product.words_[i + j];
      product.words_[i + j] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
  }
  return product;
}

int Wide::sign() const {
  if ((words_[kWords - 1] >> 63) != 0) return -1;
  for (const std::uint64_t word : words_) {
    if (word != 0) return 1;
  }
  return 0;
}

}  // namespace rubicon::travel
