#include "src/site/claim.hpp"

#include <algorithm>
#include <utility>

#include "src/collision/swept_volume.hpp"

namespace rubicon::site {

double claim_growth(double contact_tolerance) {
  return std::max(kClaimGrowthShare * contact_tolerance, kLeastClaimGrowth);
}

Claim::Claim(std::vector<ClaimPart> parts, double growth)
    : parts_(std::move(parts)), growth_(growth) {
  for (const ClaimPart& part : parts_) {
    bounds_.add(collision::swept_bounds(*part.body, part.motion));
  }
}

const Claim::Volume& Claim::volume() const {
  if (volume_) return *volume_;
  volume_ = std::make_unique<Volume>();
  // Ids count from 1 in a world from which nothing is removed.
  for (const ClaimPart& part : parts_) {
    for (collision::StandingPart& standing :
         collision::swept_volume(*part.body, part.motion, growth_)) {
      volume_->world.insert(std::move(standing.body), standing.X_WB);
      volume_->part_of.push_back(part.part);
    }
  }
  return *volume_;
}

std::optional<Claim::Hit> Claim::meets(const collision::SweptQuery& query,
                                       const collision::Bounds& bounds) const {
  if (bounds.disjoint(bounds_)) return std::nullopt;
  const Volume& own = volume();
  const collision::SweptResult result = own.world.test(query);
  if (!result.hit) return std::nullopt;
  return Hit{result.hit->item, own.part_of[*result.hit->obstacle - 1]};
}

collision::Bounds swept_bounds(const collision::SweptQuery& query) {
  collision::Bounds bounds;
  for (const collision::SweptQuery::Item& item : query.items) {
    bounds.add(collision::swept_bounds(*item.moving.body, item.moving.motion));
  }
  return bounds;
}

}  // namespace rubicon::site
