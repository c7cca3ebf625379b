#include "src/simulation/site/reserved_volume.hpp"

#include <algorithm>
#include <utility>

namespace rubicon::site {

double reserved_growth(double contact_tolerance) {
  return std::max(kReservedGrowthShare * contact_tolerance, kLeastReservedGrowth);
}

ReservedVolume::ReservedVolume(std::vector<ReservedPart> parts, double growth) {
  for (ReservedPart& part : parts) {
    parts_.push_back(
        {{std::move(part.body), std::move(part.motion), growth}, part.part, part.is_buffer});
    bounds_.add(parts_.back().volume.bounds());
  }
}

std::optional<ReservedVolume::Hit> ReservedVolume::meets(
    collision::MovingBodies& bodies, const std::vector<bool>& are_buffers) const {
  if (bodies.bounds().disjoint(bounds_)) return std::nullopt;
  for (int item = 0; item < bodies.count(); ++item) {
    const bool is_buffer = !are_buffers.empty() && are_buffers[static_cast<std::size_t>(item)];
    for (const Part& part : parts_) {
      if (is_buffer && part.is_buffer) continue;
      if (part.volume.meets(bodies, item)) return Hit{item, part.part};
    }
  }
  return std::nullopt;
}

}  // namespace rubicon::site
