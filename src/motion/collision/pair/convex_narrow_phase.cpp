#include "src/motion/collision/pair/convex_narrow_phase.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/convex/separation.hpp"

namespace rubicon::collision {
namespace {

class ConvexNarrowPhase {
 public:
  ConvexNarrowPhase(const Convex& a, const Convex& b, const RelativeMotion& motion,
                    double tolerance)
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
      radius_a_ = a.radius_about(axis_in_a_, motion.axis_in_a().point);
      radius_b_ = b.radius_about(axis_in_b_, motion.axis_in_b().point);
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

  int intervals() const { return intervals_; }

  std::optional<double> first_contact(MotionTree& tree, double before) {
    const Slice& slice = tree.slice();
    if (free_on(slice)) return std::nullopt;
    if (before < slice.s1 && free_on(tree.motion().slice(slice.s0, before))) return std::nullopt;
    if (!free_at(slice.a_in_b.start)) return slice.s0;
    if (kind_ == RelativeMotion::Kind::kStill) return slice.s0;
    if (kind_ == RelativeMotion::Kind::kTranslation) return end_of_free_translation(tree);
    const std::optional<double> found = first_contact_inside(tree);
    // What the search for a hit gave up on must not be lost here.
    if (!found && blocked(tree)) return slice.s0;
    return found;
  }

 private:
  /// The swept volume only grows with the distance, so halving finds where it gets too deep.
  double end_of_free_translation(const MotionTree& tree) {
    double accepted = tree.slice().s0;
    double refused = tree.slice().s1;
    while (refused - accepted > kContactResolution) {
      const double middle = 0.5 * (accepted + refused);
      const bool free = free_on(tree.motion().slice(tree.slice().s0, middle));
      (free ? accepted : refused) = middle;
    }
    return accepted;
  }

  std::optional<double> first_contact_inside(MotionTree& tree) {
    const Slice& slice = tree.slice();
    if (free_on(slice)) return std::nullopt;
    if (!free_at(slice.a_in_b.start) || ++intervals_ > kMaxIntervals) return slice.s0;
    if (slice.s1 - slice.s0 <= kContactResolution) {
      const bool deep = !free_at(slice.a_in_b.end) || undecided_blocked(tree);
      return deep ? std::optional(slice.s0) : std::nullopt;
    }
    if (const std::optional<double> found = first_contact_inside(tree.first_half())) return found;
    return first_contact_inside(tree.second_half());
  }

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
    set(a_in_b_, slice.a_in_b, slice.unit_sagitta * radius_a_);
    if (separated(a_in_b_)) return true;
    if (kind_ != RelativeMotion::Kind::kScrew && kind_ != RelativeMotion::Kind::kGeneral)
      return false;
    set(b_in_a_, slice.b_in_a, slice.unit_sagitta * radius_b_);
    return separated(b_in_a_);
  }

  bool free_at(const Placement& pose) {
    a_in_b_.stand_at(pose);
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

  /// How far the middle of A gets, as B sees it.
  double travel(const Slice& slice) const {
    const Vec3 centre = a_in_b_.moving.bounds.centre();
    return (slice.a_in_b.end * centre - slice.a_in_b.start * centre).norm();
  }

  bool fine_enough(const Slice& slice) const {
    if (slice.s1 - slice.s0 < kShortestInterval) return true;
    const double growth =
        std::max(slice.unit_sagitta * std::max(radius_a_, radius_b_),
                 std::max(slice.a_in_b.uniform_growth, slice.b_in_a.uniform_growth));
    return growth <= resolution_ && 0.5 * slice.turn * size_ <= kTurnResolution &&
           travel(slice) <= kTravelResolution;
  }

  RelativeMotion::Kind kind_;
  Vec3 axis_in_a_;
  Vec3 axis_in_b_;
  SweptPair a_in_b_;
  SweptPair b_in_a_;
  double radius_a_ = 0;
  double radius_b_ = 0;
  double size_ = 0;
  double resolution_ = 0;
  int intervals_ = 0;
};

}  // namespace

bool pair_blocked(const Convex& a, const Convex& b, MotionTree& tree, double tolerance,
                  int& intervals) {
  ConvexNarrowPhase pair(a, b, tree.motion(), tolerance);
  const bool blocked = pair.blocked(tree);
  intervals += 1 + pair.intervals();
  return blocked || intervals > kMaxIntervalsOfBodies;
}

std::optional<double> first_contact(const Convex& a, const Convex& b, MotionTree& tree,
                                    double tolerance, double before) {
  return ConvexNarrowPhase(a, b, tree.motion(), tolerance).first_contact(tree, before);
}

}  // namespace rubicon::collision
