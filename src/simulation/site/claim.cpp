#include "src/simulation/site/claim.hpp"

#include <algorithm>
#include <utility>

namespace rubicon::site {

double claim_growth(double contact_tolerance) {
  return std::max(kClaimGrowthShare * contact_tolerance, kLeastClaimGrowth);
}

Claim::Claim(std::vector<ClaimPart> parts, double growth) {
  for (ClaimPart& part : parts) {
    parts_.push_back({{std::move(part.body), std::move(part.motion), growth}, part.part});
    bounds_.add(parts_.back().volume.bounds());
  }
}

std::optional<Claim::Hit> Claim::meets(collision::MovingBodies& bodies) const {
  if (bodies.bounds().disjoint(bounds_)) return std::nullopt;
  for (int item = 0; item < bodies.count(); ++item) {
    for (const Part& part : parts_) {
      if (part.volume.meets(bodies, item)) return Hit{item, part.part};
    }
  }
  return std::nullopt;
}

}  // namespace rubicon::site
