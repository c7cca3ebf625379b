#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// What the weather takes of a calendar.
struct LostDates {
  std::int64_t working_days = 0;   ///< lost or not
  std::vector<std::int64_t> days;  ///< since 1970-01-01
};

/// When those work who keep to calendars, by looking at one day after the other.
class WorkingHours {
 public:
  /// Throws UnreadableInput for dates that are none. A plan without `start_at` begins on a Monday
  /// at 00:00.
  explicit WorkingHours(const Scene& scene);

  /// Time between two moments at which all of these calendars work; all of it if there are none.
  Ticks between(std::span<const int> calendars, Ticks from, Ticks to) const;

  /// Whether all work at the moment, or within kTimeSlack of it.
  bool at(std::span<const int> calendars, Ticks time) const;

  /// Of a calendar, up to a moment: drawn once more.
  LostDates lost_until(int calendar, Ticks end) const;

 private:
  using Interval = std::pair<Ticks, Ticks>;  ///< of a day
  struct Calendar {
    std::vector<std::vector<Interval>> week;  ///< by weekday, Monday first; in order, apart
    std::set<std::int64_t> off;               ///< days since 1970-01-01
    std::vector<double> lost;                 ///< share by month; empty: none
  };
  /// `day` counts from the first day of the plan.
  std::vector<Interval> hours(std::span<const int> calendars, std::int64_t day) const;

  bool is_lost(int index, std::int64_t day) const;

  std::vector<Calendar> calendars_;
  std::uint64_t seed_ = 0, run_ = 0;
  std::int64_t first_day_ = 0;  ///< of the plan, since 1970-01-01
  Ticks start_ = 0;             ///< since the midnight before it
};

}  // namespace rubicon::verify
