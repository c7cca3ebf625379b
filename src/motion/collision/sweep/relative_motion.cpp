#include "src/motion/collision/sweep/relative_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "src/motion/math/angles.hpp"

namespace rubicon::collision {
namespace {

using geometry::GeneralMotion;
using geometry::ScrewMotion;

/// Greatest stretch of the difference of two rotations: 2 sin(half the angle between them).
double stretch(const Mat3& difference) { return difference.norm() / std::sqrt(2.0); }

/// How far a vector of this length, fixed in the body, deviates from its chord.
double chord_deviation_of_vector(const Motion& motion, double length, double s0, double s1) {
  if (const ScrewMotion* screw = screw_of(motion)) {
    return length * unit_sagitta_of(screw->angle_deg * (s1 - s0));
  }
  const GeneralMotion* general = general_of(motion);
  if (general == nullptr) return 0;
  return general->chord_deviation(s0, s1, length) + general->chord_deviation(s0, s1, 0);
}

/// Bound of how far n.x deviates from its chord, for core points x of the moving body and any unit
/// n fixed in the other (docs/collision.md, "two bodies that both move").
double general_growth(const Motion& moving, const BodyExtent& moving_extent, const Motion& fixed,
                      const BodyExtent& fixed_extent, double s0, double s1) {
  const Placement moving0 = centred(moving, moving_extent, s0);
  const Placement moving1 = centred(moving, moving_extent, s1);
  const Placement fixed0 = centred(fixed, fixed_extent, s0);
  const Placement fixed1 = centred(fixed, fixed_extent, s1);
  const ChordDeviation deviation = chord_deviation_of(moving, moving_extent, s0, s1);
  const double arm_deviation =
      deviation.points + chord_deviation_of(fixed, fixed_extent, s0, s1).centre;
  const double arm = std::max((moving0.t - fixed0.t).norm(), (moving1.t - fixed1.t).norm()) +
                     moving_extent.radius + arm_deviation;
  const double arm_change = stretch(moving1.R - moving0.R) * moving_extent.radius +
                            ((moving1.t - moving0.t) - (fixed1.t - fixed0.t)).norm();
  const double growth = 0.25 * stretch(fixed1.R - fixed0.R) * arm_change +
                        chord_deviation_of_vector(fixed, arm, s0, s1) + arm_deviation;
  // A motion that cannot bound itself must not pass for one that is well known.
  return growth >= 0 ? growth : std::numeric_limits<double>::infinity();
}

bool parallel(const Vec3& axis, const Vec3& slide) {
  return (axis.cross(slide).array() == 0).all();
}

/// Whether two screws turn and slide about the very same line, so that the one seen from the other
/// is a screw again.
bool share_axis(const ScrewMotion& a, const ScrewMotion& b) {
  if (a.angle_deg != 0 && b.angle_deg != 0) return a.axis == b.axis && a.point == b.point;
  return a.angle_deg != 0 ? parallel(a.axis, b.slide) : parallel(b.axis, a.slide);
}

}  // namespace

RelativeMotion::RelativeMotion(const Motion& a, const BodyExtent& extent_a, const Motion& b,
                               const BodyExtent& extent_b)
    : a_(a), b_(b), extent_a_(extent_a), extent_b_(extent_b) {
  require_valid(a);
  require_valid(b);
  initial_ = relative(centred(a, extent_a, 0), centred(b, extent_b, 0));
  const ScrewMotion* screw_a = screw_of(a);
  const ScrewMotion* screw_b = screw_of(b);
  if (screw_a == nullptr || screw_b == nullptr) {
    const bool same_motion =
        general_of(a) == general_of(b) && screw_a == nullptr && screw_b == nullptr;
    kind_ = same_motion ? Kind::kStill : Kind::kGeneral;
    return;
  }
  if (screw_a->angle_deg != 0 || screw_b->angle_deg != 0) {
    if (!share_axis(*screw_a, *screw_b)) {
      kind_ = Kind::kGeneral;
      return;
    }
    set_screw(screw_a->angle_deg != 0 ? a : b, screw_a->angle_deg - screw_b->angle_deg,
              screw_a->slide - screw_b->slide);
    return;
  }
  set_screw(a, 0, screw_a->slide - screw_b->slide);
}

void RelativeMotion::set_screw(const Motion& frame, double angle_deg, const Vec3& slide) {
  const ScrewMotion& screw = *screw_of(frame);
  const Placement a = centred(a_, extent_a_, 0);
  const Placement b = centred(b_, extent_b_, 0);
  angle_deg_ = angle_deg;
  slide_ = b.R.transpose() * slide;
  if (angle_deg == 0) {
    kind_ = (slide.array() == 0).all() ? Kind::kStill : Kind::kTranslation;
    return;
  }
  kind_ = Kind::kScrew;
  const auto axis_seen_from = [&](const Placement& body) {
    Axis seen;
    seen.axis = body.R.transpose() * screw.axis;
    seen.point = body.R.transpose() * (screw.point - body.t);
    seen.point -= seen.axis * seen.axis.dot(seen.point);
    return seen;
  };
  axis_in_b_ = axis_seen_from(b);
  axis_in_a_ = axis_seen_from(a);
}

Placement RelativeMotion::pose(double s) const {
  switch (kind_) {
    case Kind::kStill:
      return initial_;
    case Kind::kTranslation:
      return {initial_.R, initial_.t + s * slide_};
    case Kind::kScrew: {
      const Mat3 turned = math::rotation_about_deg(axis_in_b_.axis, s * angle_deg_);
      return {turned * initial_.R,
              axis_in_b_.point + turned * (initial_.t - axis_in_b_.point) + s * slide_};
    }
    case Kind::kGeneral:
      break;
  }
  return relative(centred(a_, extent_a_, s), centred(b_, extent_b_, s));
}

Slice RelativeMotion::slice(double s0, double s1) const {
  Slice slice;
  slice.s0 = s0;
  slice.s1 = s1;
  View& view = slice.a_in_b;
  view.start = pose(s0);
  view.middle = pose(0.5 * (s0 + s1));
  view.end = pose(s1);
  slice.b_in_a = {view.start.inverse(), view.middle.inverse(), view.end.inverse(), 0};
  if (kind_ == Kind::kScrew) {
    slice.unit_sagitta = unit_sagitta_of(angle_deg_ * (s1 - s0));
    slice.turn = math::radians(std::fabs(angle_deg_)) * (s1 - s0);
  }
  if (kind_ == Kind::kGeneral) {
    slice.a_in_b.uniform_growth = general_growth(a_, extent_a_, b_, extent_b_, s0, s1);
    slice.b_in_a.uniform_growth = general_growth(b_, extent_b_, a_, extent_a_, s0, s1);
    slice.turn = stretch(view.end.R - view.start.R);
  }
  return slice;
}

}  // namespace rubicon::collision
