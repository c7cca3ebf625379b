#pragma once

#include <cstdint>

#include "src/motion/math/angles.hpp"

/// Small functions that work on lanes are always inlined: so they are compiled for the processor of
/// the function that they end up in, and no other form of them is left for the linker to choose.
#define RUBICON_LANES [[gnu::always_inline]] inline

/// A function that is compiled for processors with AVX2, to be entered on these only. It does the
/// same as it does elsewhere, sooner.
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define RUBICON_AVX2 [[gnu::target("avx2")]]
#else
#define RUBICON_AVX2
#endif

namespace rubicon::math {

inline bool processor_has_avx2() {
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

/// Four numbers that are computed with at once. Each lane is what the same operations give for one
/// number, bit by bit, whatever the processor has: nothing is fused or reordered. In a structure,
/// since compilers warn of bare vectors in calls, and align them by what the processor has.
struct alignas(32) Lanes {
  using Vector [[gnu::vector_size(32)]] = double;
  Vector v{};
};

/// To each lane: all bits, or none.
struct alignas(32) LaneMask {
  using Vector [[gnu::vector_size(32)]] = std::int64_t;
  Vector v{};
};

inline constexpr int kLanes = 4;

RUBICON_LANES Lanes lanes(double x) { return {Lanes::Vector{x, x, x, x}}; }
RUBICON_LANES Lanes lanes(double a, double b, double c, double d) {
  return {Lanes::Vector{a, b, c, d}};
}

RUBICON_LANES Lanes operator+(const Lanes& a, const Lanes& b) { return {a.v + b.v}; }
RUBICON_LANES Lanes operator-(const Lanes& a, const Lanes& b) { return {a.v - b.v}; }
RUBICON_LANES Lanes operator*(const Lanes& a, const Lanes& b) { return {a.v * b.v}; }
RUBICON_LANES Lanes operator-(const Lanes& a) { return {-a.v}; }

RUBICON_LANES LaneMask operator>(const Lanes& a, const Lanes& b) {
  return {(LaneMask::Vector)(a.v > b.v)};
}
RUBICON_LANES LaneMask operator&(const LaneMask& a, const LaneMask& b) { return {a.v & b.v}; }
RUBICON_LANES LaneMask operator|(const LaneMask& a, const LaneMask& b) { return {a.v | b.v}; }
RUBICON_LANES LaneMask operator~(const LaneMask& a) { return {~a.v}; }
RUBICON_LANES LaneMask no_lane() { return {LaneMask::Vector{0, 0, 0, 0}}; }

/// Bit i: lane i.
RUBICON_LANES unsigned bits(const LaneMask& mask) {
  return static_cast<unsigned>((mask.v[0] & 1) | (mask.v[1] & 2) | (mask.v[2] & 4) |
                               (mask.v[3] & 8));
}

RUBICON_LANES Lanes select(const LaneMask& mask, const Lanes& yes, const Lanes& no) {
  return {(Lanes::Vector)((mask.v & (LaneMask::Vector)yes.v) | (~mask.v & (LaneMask::Vector)no.v))};
}
RUBICON_LANES Lanes abs(const Lanes& a) {
  constexpr std::int64_t kNoSign = INT64_MAX;
  return {(Lanes::Vector)((LaneMask::Vector)a.v &
                          LaneMask::Vector{kNoSign, kNoSign, kNoSign, kNoSign})};
}

struct LaneSineCosine {
  Lanes sine;
  Lanes cosine;
};

/// Of angles in degrees, to 1e-13; below 1e12 degrees.
RUBICON_LANES LaneSineCosine sine_cosine_deg(const Lanes& degrees) {
  // The nearest multiple of 90 degrees: where this is added no binary place is left for fractions.
  constexpr double kNoFractions = 6755399441055744.0;
  const Lanes shifted = degrees * lanes(1.0 / 90.0) + lanes(kNoFractions);
  const Lanes quarters = shifted - lanes(kNoFractions);
  const Lanes x = (degrees - quarters * lanes(90.0)) * lanes(radians(1));
  const Lanes u = x * x;
  // Taylor, up to x^13 and x^14.
  Lanes s = lanes(1.0 / 6227020800.0);
  s = s * u - lanes(1.0 / 39916800.0);
  s = s * u + lanes(1.0 / 362880.0);
  s = s * u - lanes(1.0 / 5040.0);
  s = s * u + lanes(1.0 / 120.0);
  s = s * u - lanes(1.0 / 6.0);
  s = s * u * x + x;
  Lanes c = lanes(-1.0 / 87178291200.0);
  c = c * u + lanes(1.0 / 479001600.0);
  c = c * u - lanes(1.0 / 3628800.0);
  c = c * u + lanes(1.0 / 40320.0);
  c = c * u - lanes(1.0 / 720.0);
  c = c * u + lanes(1.0 / 24.0);
  c = c * u - lanes(0.5);
  c = c * u + lanes(1.0);
  // The last two bits of `shifted` are the quarter turn: odd ones swap the two, then the signs.
  const LaneMask::Vector turn = (LaneMask::Vector)shifted.v;
  const LaneMask swapped{(LaneMask::Vector)(-(turn & 1))};
  const LaneMask::Vector sine_sign = (turn & 2) << 62;
  const LaneMask::Vector cosine_sign = ((turn + 1) & 2) << 62;
  const Lanes sine = select(swapped, c, s);
  const Lanes cosine = select(swapped, s, c);
  return {{(Lanes::Vector)((LaneMask::Vector)sine.v ^ sine_sign)},
          {(Lanes::Vector)((LaneMask::Vector)cosine.v ^ cosine_sign)}};
}

/// Where a frame is at four shares of a motion, and how it moves there by the share. World; plain
/// data.
struct LaneFrame {
  Lanes R[3][3];  ///< row, column
  Lanes t[3];     ///< m
  Lanes v[3];     ///< m, of its origin
  Lanes w[3];     ///< rad
};

}  // namespace rubicon::math
