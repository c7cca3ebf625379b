#include "src/motion/collision/convex/separation.hpp"

#include <algorithm>

#include "src/motion/collision/convex/expanding_polytope.hpp"
#include "src/motion/collision/convex/gjk.hpp"
#include "src/motion/collision/convex/separating_axes.hpp"

namespace rubicon::collision {
namespace {

/// Up to this many axes are all tried; beyond it the expanding polytope is quicker.
constexpr std::size_t kMaxAxes = 160;

/// The pair's bounding boxes along the axes of the fixed frame: cheap, and decides most pairs.
bool bounds_separated(const SweptPair& pair) {
  Bounds swept = placed(pair.moving.bounds, pair.start);
  if (!pair.standing) {
    swept.add(placed(pair.moving.bounds, pair.end));
    swept.grow(
        {pair.growth(Vec3::UnitX()), pair.growth(Vec3::UnitY()), pair.growth(Vec3::UnitZ())});
  }
  const Bounds& fixed = pair.fixed.bounds;
  return ((swept.upper - fixed.lower).array() <= pair.tolerance).any() ||
         ((fixed.upper - swept.lower).array() <= pair.tolerance).any();
}

}  // namespace

bool separated(const SweptPair& pair) {
  if (bounds_separated(pair)) return true;
  const bool polytopes = pair.balls() == 0 && pair.moving.disc == 0 && pair.fixed.disc == 0;
  const bool few_axes = separating_axis_count(pair) <= kMaxAxes;
  if (polytopes && few_axes) return separating_axis_exists(pair);
  if (contact_axis_exists(pair)) return true;
  const GjkResult result = gjk(pair);
  if (result.free) return true;
  if (!result.cores_meet) return false;
  // Where cores meet, every direction overlaps by at least the balls' radii.
  if (pair.balls() > pair.tolerance) return false;
  return shallow_direction_exists(pair, result.simplex);
}

}  // namespace rubicon::collision
