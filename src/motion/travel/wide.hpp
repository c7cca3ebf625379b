#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rubicon::travel {

__extension__ typedef __int128 Int128;            ///< signed, 128 bits
__extension__ typedef unsigned __int128 UInt128;  ///< unsigned, 128 bits

/// a b, of numbers whose product fits in 128 bits.
inline Int128 times(Int128 a, Int128 b) {
  return static_cast<Int128>(static_cast<UInt128>(a) * static_cast<UInt128>(b));
}

/// A whole number of 384 bits with sign (two's complement): what exact predicates of crossings need
/// at most is 327 bits. Sums and products that do not fit wrap.
class Wide {
 public:
  Wide(Int128 value);  // NOLINT: a number is a wide number

  friend Wide operator+(const Wide& a, const Wide& b);
  friend Wide operator-(const Wide& a, const Wide& b);
  friend Wide operator*(const Wide& a, const Wide& b);
  /// -1, 0 or 1.
  int sign() const;

 private:
  static constexpr std::size_t kWords = 6;
  Wide() = default;
  std::array<std::uint64_t, kWords> words_{};  ///< lowest first
};

/// -1, 0 or 1.
inline int sign_of(Int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

}  // namespace rubicon::travel
