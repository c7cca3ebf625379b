#include "src/simulation/schedule/lost_days.hpp"

#include <algorithm>

#include "src/simulation/sampling/duration_law.hpp"
#include "src/simulation/schedule/civil_time.hpp"

namespace rubicon::schedule {

bool LostDays::is_lost(std::int64_t day) const {
  const double share = shares[static_cast<std::size_t>(date_from_days(day).month - 1)];
  if (share <= 0) return false;
  const sampling::Place place{weather.seed, weather.run, "weather",
                              static_cast<std::uint64_t>(day)};
  return sampling::uniform_draw(place) < share;
}

LostDays both_lost(const LostDays& a, const LostDays& b) {
  LostDays result = a;
  for (std::size_t i = 0; i < result.shares.size(); ++i) {
    result.shares[i] = std::max(a.shares[i], b.shares[i]);
  }
  return result;
}

}  // namespace rubicon::schedule
