#pragma once

#include <array>
#include <cstdint>

namespace rubicon::schedule {

/// By month, January first: the share of working days that is lost.
using LostShares = std::array<double, 12>;

/// What the weather of a run is drawn by.
struct Weather {
  std::uint64_t seed = 1;
  std::uint64_t run = 0;
  bool operator==(const Weather&) const = default;
};

/// Which days the weather takes. Each date has one weather, the same for all calendars: what is
/// lost with a share is lost with a greater one, too.
struct LostDays {
  LostShares shares = {};
  Weather weather = {};

  /// The day, counted from 1970-01-01.
  bool is_lost(std::int64_t day) const;
  bool operator==(const LostDays&) const = default;
};

/// What is lost with either, of the same weather.
LostDays both_lost(const LostDays& a, const LostDays& b);

}  // namespace rubicon::schedule
