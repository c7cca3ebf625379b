#include "src/results/verify/charts/whereabouts.hpp"

#include <algorithm>

namespace rubicon::verify {

Whereabouts whereabouts(const std::vector<ChartStop>& stops, Ticks now) {
  Whereabouts result;
  if (stops.front().arrival > now) {
    result.kind = stops.front().node >= 0 ? Whereabouts::Kind::not_started
                                          : Whereabouts::Kind::at_present_place;
    result.next = stops.front().node >= 0 ? 0 : 1;
    return result;
  }
  std::size_t last = 0;
  while (last + 1 < stops.size() && stops[last + 1].arrival <= now) ++last;
  result.next = last + 1;
  if (result.next < stops.size()) {
    const ChartStop& next = stops[result.next];
    if (next.arrival - next.travel < now && stops[last].arrival < now) {
      result.kind = Whereabouts::Kind::in_motion;
      result.remaining = std::min(next.travel, next.arrival - now);
      return result;
    }
  }
  result.kind =
      stops[last].node >= 0 ? Whereabouts::Kind::at_node : Whereabouts::Kind::at_present_place;
  result.node = stops[last].node;
  return result;
}

}  // namespace rubicon::verify
