#include "src/motion/collision/pair/body_clearance.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/convex/closest_points.hpp"
#include "src/motion/collision/pair/containment.hpp"
#include "src/motion/collision/pair/part_pairs.hpp"
#include "src/motion/collision/sweep/motion_tree.hpp"

namespace rubicon::collision {
namespace {

/// Intervals one pair of pieces may look at before its bounds are taken as they are.
constexpr int kMaxLooks = 1 << 12;

/// Two bodies' pieces, one pair after the other, by branch and bound over the step.
class ClearanceSearch {
 public:
  ClearanceSearch(const Body& a, const Body& b, const RelativeMotion& motion,
                  const Motion& motion_b, NearestMiss& nearest)
      : a_(a), b_(b), motion_(motion), motion_b_(motion_b), nearest_(nearest) {}

  bool run(double contact_tolerance) {
    const int count = useful_slices(motion_, a_.extent().radius + b_.extent().radius);
    const PartPairs pairs(a_, b_, motion_);
    reach_ = nearest_.reach();
    for (int i = 0; i < count; ++i) {
      MotionTree tree(motion_, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
      const View& view = tree.slice().a_in_b;
      if (i == 0) overlap_if_contained(view.start, contact_tolerance, 0);
      if (i + 1 == count) overlap_if_contained(view.end, contact_tolerance, 1);
      const auto look = [&](const Convex& piece_a, const Convex& piece_b) {
        begin(piece_a, piece_b);
        search(tree);
        return nearest_.found <= 0;
      };
      if (pairs.any(tree.slice(), reach_, look)) break;
    }
    return improved_;
  }

 private:
  void begin(const Convex& a, const Convex& b) {
    pair_.moving = a;
    pair_.fixed = b;
    pair_.growth_axis = motion_.axis_in_b().axis;
    radius_ = motion_.kind() == RelativeMotion::Kind::kScrew
                  ? a.radius_about(motion_.axis_in_a().axis, motion_.axis_in_a().point)
                  : 0;
    looks_ = 0;
  }

  void search(MotionTree& tree) {
    const Slice& slice = tree.slice();
    pair_.standing = motion_.kind() == RelativeMotion::Kind::kStill;
    pair_.start = slice.a_in_b.start;
    pair_.middle = slice.a_in_b.middle;
    pair_.end = slice.a_in_b.end;
    pair_.axial_growth = slice.unit_sagitta * radius_;
    pair_.uniform_growth = slice.a_in_b.uniform_growth;
    const double lower = closest_points(pair_).lower_bound;
    if (lower >= nearest_.reach() - nearest_.resolution) {
      nearest_.certified = std::min(nearest_.certified, lower);
      if (lower >= nearest_.reach()) return;
    }
    const double found = look_at(slice.a_in_b.middle, 0.5 * (slice.s0 + slice.s1));
    const bool decided = found - lower <= nearest_.resolution || pair_.standing ||
                         lower >= nearest_.reach() - nearest_.resolution ||
                         slice.s1 - slice.s0 < kShortestInterval || ++looks_ > kMaxLooks;
    if (decided || nearest_.found <= 0) {
      nearest_.certified = std::min(nearest_.certified, lower);
      return;
    }
    search(tree.first_half());
    search(tree.second_half());
  }

  /// The distance at one pose.
  double look_at(const Placement& pose, double fraction) {
    SweptPair still = pair_;
    still.stand_at(pose);
    const ClosestPoints points = closest_points(still);
    if (points.upper_bound < nearest_.found) {
      note(points.upper_bound, fraction, points.moving, points.fixed);
    }
    return points.upper_bound;
  }

  void overlap_if_contained(const Placement& a_in_b, double contact_tolerance, double fraction) {
    if (nearest_.found <= 0) return;
    if (const auto point = contained_point(a_, b_, a_in_b, contact_tolerance)) {
      note(0, fraction, *point, *point);
      nearest_.certified = 0;
    }
  }

  void note(double distance, double fraction, const Vec3& on_a, const Vec3& on_b) {
    improved_ = true;
    nearest_.found = distance;
    nearest_.fraction = fraction;
    const Placement X_WB = centred(motion_b_, b_.extent(), fraction);
    nearest_.on_a_W = X_WB * on_a;
    nearest_.on_b_W = X_WB * on_b;
    reach_ = nearest_.reach();
  }

  const Body& a_;
  const Body& b_;
  const RelativeMotion& motion_;
  const Motion& motion_b_;
  NearestMiss& nearest_;
  SweptPair pair_;
  double radius_ = 0;
  double reach_ = 0;
  int looks_ = 0;
  bool improved_ = false;
};

}  // namespace

bool add_clearance(const Body& a, const Motion& motion_a, const Body& b, const Motion& motion_b,
                   double contact_tolerance, NearestMiss& nearest) {
  const RelativeMotion motion(motion_a, a.extent(), motion_b, b.extent());
  return ClearanceSearch(a, b, motion, motion_b, nearest).run(contact_tolerance);
}

}  // namespace rubicon::collision
