#include "src/simulation/site/reserved_volume.hpp"

#include <algorithm>
#include <utility>

namespace rubicon::site {

double reserved_growth(double contact_tolerance) {
  return std::max(kReservedGrowthShare * contact_tolerance, kLeastReservedGrowth);
}

ReservedVolume::ReservedVolume(std::vector<ReservedPart> parts, double growth) {
  for (ReservedPart& part : parts) {
    parts_.push_back({{std::move(part.body), std::move(part.motion), growth}, part.part});
    bounds_.add(parts_.back().volume.bounds());
  }
}

std::optional<ReservedVolume::Hit> ReservedVolume::meets(collision::MovingBodies& bodies) const {
  if (bodies.bounds().disjoint(bounds_)) return std::nullopt;
  for (int item = 0; item < bodies.count(); ++item) {
    for (const Part& part : parts_) {
      if (part.volume.meets(bodies, item)) return Hit{item, part.part};
    }
  }
  return std::nullopt;
}

}  // namespace rubicon::site
