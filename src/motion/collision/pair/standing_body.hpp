#pragma once

#include "src/motion/collision/sweep/body.hpp"
#include "src/motion/collision/sweep/sweep.hpp"

namespace rubicon::collision {

/// Where a body stands: the pose of its own frame, and of its centred coordinates.
struct StandingPlace {
  Pose X_WB = Pose::Identity();
  Placement X_WC;

  StandingPlace() = default;
  StandingPlace(const Body& body, const Pose& pose);
};

/// Whether a moving body meets one that stands, deeper than the tolerance (m) or inside it.
bool blocked_by_standing(Sweep& sweep, const Body& standing, const StandingPlace& place,
                         double contact_tolerance);

}  // namespace rubicon::collision
