#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rubicon::schedule {

/// A moment or a duration in integer nanoseconds; moments count from the start of the plan.
using Ticks = std::int64_t;

inline constexpr Ticks kSecond = 1'000'000'000;
inline constexpr Ticks kMinute = 60 * kSecond;
inline constexpr Ticks kHour = 60 * kMinute;
inline constexpr Ticks kDay = 24 * kHour;
inline constexpr Ticks kWeek = 7 * kDay;

inline constexpr double kTicksPerSecond = 1e9;

/// A duration in ticks, rounded once, half away from zero and without the rounding mode; saturates
/// far beyond any construction site (292 years).
inline Ticks ticks_from_seconds(double seconds) {
  constexpr double kLargest = 9.2e18;
  const double ticks = seconds * kTicksPerSecond;
  if (!(ticks < kLargest)) return static_cast<Ticks>(kLargest);
  if (ticks < -kLargest) return -static_cast<Ticks>(kLargest);
  return static_cast<Ticks>(ticks < 0 ? -std::floor(-ticks + 0.5) : std::floor(ticks + 0.5));
}

inline double seconds_from_ticks(Ticks ticks) {
  return static_cast<double>(ticks) / kTicksPerSecond;
}

/// Moments lie between -kEndOfTime and kEndOfTime (126 years), so that the sum of any two fits in
/// 64 bits. What would be later is kEndOfTime, which means "not at any time that a plan can reach".
inline constexpr Ticks kEndOfTime = 4'000'000'000'000'000'000;

/// The moment or duration, or the nearest one that can be counted with.
constexpr Ticks within_time(Ticks time) { return std::clamp(time, -kEndOfTime, kEndOfTime); }

/// The largest multiple of `unit` (> 0) that is not above `value`, divided by it; rounds down where
/// `/` rounds towards zero.
constexpr std::int64_t floor_division(std::int64_t value, std::int64_t unit) {
  return value / unit - (value % unit < 0 ? 1 : 0);
}

}  // namespace rubicon::schedule
