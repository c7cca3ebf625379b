#include "src/collision/pair_test.hpp"

#include <algorithm>
#include <cmath>

#include "src/collision/separation.hpp"
#include "src/collision/tolerances.hpp"

namespace rubicon::collision {
namespace {

class PairTest {
 public:
  PairTest(const Convex& a, const Convex& b, const RelativeMotion& motion, double tolerance)
      : kind_(motion.kind()),
        axis_in_a_(motion.axis_in_a().axis),
        axis_in_b_(motion.axis_in_b().axis) {
    a_in_b_.moving = a;
    a_in_b_.fixed = b;
    a_in_b_.tolerance = tolerance;
    b_in_a_.moving = b;
    b_in_a_.fixed = a;
    b_in_a_.tolerance = tolerance;
    if (kind_ == RelativeMotion::Kind::kScrew) {
      a_in_b_.growth_axis = axis_in_b_;
      b_in_a_.growth_axis = axis_in_a_;
      lever_a_ = a.lever(axis_in_a_, motion.axis_in_a().point);
      lever_b_ = b.lever(axis_in_b_, motion.axis_in_b().point);
    }
    size_ = 2 * std::min(a.bounds.half().norm(), b.bounds.half().norm());
    resolution_ = kind_ == RelativeMotion::Kind::kScrew
                      ? kScrewResolution
                      : std::clamp(tolerance / 4, kScrewResolution, kGeneralResolution);
  }

  bool blocked(MotionTree& tree) {
    const Slice& slice = tree.slice();
    if (free_on(slice)) return false;
    if (kind_ == RelativeMotion::Kind::kStill || kind_ == RelativeMotion::Kind::kTranslation)
      return true;
    if (!free_at(slice.a_in_b.start) || !free_at(slice.a_in_b.end)) return true;
    return undecided_blocked(tree);
  }

 private:
  bool blocked_inside(MotionTree& tree) {
    return !free_on(tree.slice()) && undecided_blocked(tree);
  }

  bool undecided_blocked(MotionTree& tree) {
    if (!free_at(tree.slice().a_in_b.middle)) return true;
    if (fine_enough(tree.slice()) || ++intervals_ > kMaxIntervals) return true;
    return blocked_inside(tree.first_half()) || blocked_inside(tree.second_half());
  }

  /// A direction that stands still in either body's frame will do.
  bool free_on(const Slice& slice) {
    set(a_in_b_, slice.a_in_b, slice.bulge * lever_a_);
    if (separated(a_in_b_)) return true;
    if (kind_ != RelativeMotion::Kind::kScrew && kind_ != RelativeMotion::Kind::kGeneral)
      return false;
    set(b_in_a_, slice.b_in_a, slice.bulge * lever_b_);
    return separated(b_in_a_);
  }

  bool free_at(const Placement& pose) {
    a_in_b_.standing = true;
    a_in_b_.start = pose;
    a_in_b_.middle = pose;
    return separated(a_in_b_);
  }

  void set(SweptPair& pair, const View& view, double axial_growth) const {
    pair.standing = kind_ == RelativeMotion::Kind::kStill;
    pair.start = view.start;
    pair.middle = view.middle;
    pair.end = view.end;
    pair.axial_growth = axial_growth;
    pair.uniform_growth = view.uniform_growth;
  }

  bool fine_enough(const Slice& slice) const {
    if (slice.s1 - slice.s0 < kShortestInterval) return true;
    const double growth =
        std::max(slice.bulge * std::max(lever_a_, lever_b_),
                 std::max(slice.a_in_b.uniform_growth, slice.b_in_a.uniform_growth));
    return growth <= resolution_ && 0.5 * slice.turn * size_ <= kTurnResolution;
  }

  RelativeMotion::Kind kind_;
  Vec3 axis_in_a_;
  Vec3 axis_in_b_;
  SweptPair a_in_b_;
  SweptPair b_in_a_;
  double lever_a_ = 0;
  double lever_b_ = 0;
  double size_ = 0;
  double resolution_ = 0;
  int intervals_ = 0;
};

}  // namespace

bool pair_blocked(const Convex& a, const Convex& b, MotionTree& tree, double tolerance) {
  return PairTest(a, b, tree.motion(), tolerance).blocked(tree);
}

double pair_tolerance(double width_a, double width_b, double contact_tolerance) {
  const double thin = std::max(kThinShare * std::min(width_a, width_b), kThinFloor);
  return std::max(std::min(contact_tolerance, thin), kRoundingDepth);
}

}  // namespace rubicon::collision
