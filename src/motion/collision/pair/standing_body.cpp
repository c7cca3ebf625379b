#include "src/motion/collision/pair/standing_body.hpp"

#include "src/motion/collision/pair/body_pair.hpp"
#include "src/motion/collision/pair/containment.hpp"
#include "src/motion/collision/pair/fast_path.hpp"

namespace rubicon::collision {
namespace {

/// From outside a closed mesh one must cross its surface, so the ends of the step are enough.
bool contained_on_the_way(Sweep& sweep, const Body& standing, const Placement& X_WC,
                          double tolerance) {
  const Body& body = sweep.body();
  if (!body.has_closed_soup() && !standing.has_closed_soup()) return false;
  const auto contained_at = [&](const Placement& moved) {
    return contained(body, standing, relative(moved, X_WC), tolerance);
  };
  return contained_at(sweep.slice(0).start()) ||
         (sweep.moves() && contained_at(sweep.slice(sweep.slice_count() - 1).end()));
}

}  // namespace

StandingPlace::StandingPlace(const Body& body, const Pose& pose)
    : X_WB(pose), X_WC(pose.linear(), pose * body.extent().centre) {}

bool blocked_by_standing(Sweep& sweep, const Body& standing, const StandingPlace& place,
                         double contact_tolerance) {
  const Verdict found = fast_path_verdict(sweep, standing, place.X_WC, contact_tolerance);
  if (found == Verdict::kHit) return true;
  if (found == Verdict::kUndecided) {
    return bodies_blocked(sweep.body(), sweep.motion(), standing, geometry::stationary(place.X_WB),
                          contact_tolerance);
  }
  return contained_on_the_way(sweep, standing, place.X_WC, contact_tolerance);
}

}  // namespace rubicon::collision
