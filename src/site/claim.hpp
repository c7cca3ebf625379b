#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "src/collision/bounds.hpp"
#include "src/collision/swept_query.hpp"

namespace rubicon::site {

/// By how much the volume of a step may be larger than what is swept (m): a share of the contact
/// tolerance, so that what only touches stays free. Consequence: false hits only where two machines
/// come nearer than this to the tolerance.
inline constexpr double kClaimGrowthShare = 0.25;
/// But not less (m): below it slices of a step become too many.
inline constexpr double kLeastClaimGrowth = 1e-5;

double claim_growth(double contact_tolerance);

/// One body of a claim, over a step or standing (m, world).
struct ClaimPart {
  collision::BodyPtr body;
  geometry::Motion motion;
  int part = 0;  ///< the owner's number for it
};

/// The volume that belongs to one owner: where a machine stands, all that it sweeps while a step of
/// it lasts, or a zone. Made when it is first met.
class Claim {
 public:
  Claim(std::vector<ClaimPart> parts, double growth);

  /// Which body of the query meets which part of the claim.
  struct Hit {
    int item = 0;
    int part = 0;
  };
  /// The first such pair, by the order of the query's items. `bounds` is the box around all that
  /// the query sweeps (world).
  std::optional<Hit> meets(const collision::SweptQuery& query,
                           const collision::Bounds& bounds) const;

 private:
  struct Volume {
    collision::CollisionWorld world;
    std::vector<int> part_of;  ///< by the order in which the obstacles came
  };
  const Volume& volume() const;

  std::vector<ClaimPart> parts_;
  double growth_;
  collision::Bounds bounds_;
  mutable std::unique_ptr<Volume> volume_;
};

/// The box around all that a query's bodies sweep (m, world).
collision::Bounds swept_bounds(const collision::SweptQuery& query);

}  // namespace rubicon::site
