#include "src/motion/collision/pair/part_pairs.hpp"

#include <algorithm>

#include "src/motion/collision/base/tolerances.hpp"

namespace rubicon::collision {
namespace {

double radius_about(const Bounds& bounds, const RelativeMotion::Axis& axis) {
  return axis.axis.cross(bounds.centre() - axis.point).norm() + bounds.half().norm();
}

}  // namespace

/// The box around a moving box over a slice, in the frame of the other body. `axis_here` is the
/// screw's axis in that frame, `axis_there` in the moving one.
Bounds PartPairs::swept_bounds(const Bounds& bounds, const View& view, const Slice& slice,
                               const RelativeMotion::Axis& axis_here,
                               const RelativeMotion::Axis& axis_there, double reach) {
  Bounds result = placed(bounds, view.start);
  result.add(placed(bounds, view.end));
  Vec3 growth = Vec3::Constant(view.uniform_growth + kBoundsMargin + reach);
  if (slice.unit_sagitta > 0) {
    const double sagitta = slice.unit_sagitta * radius_about(bounds, axis_there);
    for (int i = 0; i < 3; ++i) {
      growth[i] += sagitta * axis_here.axis.cross(Vec3::Unit(i)).norm();
    }
  }
  result.grow(growth);
  return result;
}

int useful_slices(const RelativeMotion& motion, double size) {
  if (motion.kind() == RelativeMotion::Kind::kStill ||
      motion.kind() == RelativeMotion::Kind::kTranslation)
    return 1;
  int count = 1;
  while (count < kMaxSlices) {
    const Slice first = motion.slice(0, 1.0 / count);
    const double growth =
        std::max(first.unit_sagitta,
                 std::max(first.a_in_b.uniform_growth, first.b_in_a.uniform_growth) / size);
    if (growth <= kUsefulGrowth) break;
    count *= 2;
  }
  return count;
}

}  // namespace rubicon::collision
