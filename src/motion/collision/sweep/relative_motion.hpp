#pragma once

#include "src/motion/collision/convex/convex.hpp"
#include "src/motion/collision/sweep/motion_bounds.hpp"

namespace rubicon::collision {

/// One body's view of the other over [s0, s1]: poses of the moving one in the frame of the fixed
/// one, and what is known of the way between them.
struct View {
  Placement start;
  Placement middle;
  Placement end;
  double uniform_growth = 0;  ///< m, general motions only
};

/// A part [s0, s1] of a step, seen from both bodies.
struct Slice {
  double s0 = 0;
  double s1 = 1;
  View a_in_b;
  View b_in_a;
  double unit_sagitta =
      0;            ///< screws: 1 - cos(half the angle); times the radius of an arc its sagitta
  double turn = 0;  ///< upper bound (near enough for stopping) of the turn between the ends, rad
};

/// The motion of body A as body B sees it, both possibly moving; everything is relative to B, so
/// that the distance of the site from the world's origin does not matter. Derivations and bounds:
/// docs/collision.md.
class RelativeMotion {
 public:
  enum class Kind { kStill, kTranslation, kScrew, kGeneral };

  /// Throws std::invalid_argument for motions that are not finite, poses that are not rigid, axes
  /// that are not unit vectors and slides across their axis.
  RelativeMotion(const Motion& a, const BodyExtent& extent_a, const Motion& b,
                 const BodyExtent& extent_b);

  Kind kind() const { return kind_; }
  Slice slice(double s0, double s1) const;

  /// The axis of a screw in the frame of B and of A: through `point`, along the unit vector `axis`.
  struct Axis {
    Vec3 axis = Vec3::UnitZ();
    Vec3 point = Vec3::Zero();
  };
  const Axis& axis_in_b() const { return axis_in_b_; }
  const Axis& axis_in_a() const { return axis_in_a_; }

 private:
  Placement pose(double s) const;
  void set_screw(const Motion& frame, double angle_deg, const Vec3& slide);

  Kind kind_ = Kind::kStill;
  Motion a_;
  Motion b_;
  BodyExtent extent_a_;
  BodyExtent extent_b_;
  Placement initial_;  ///< A in B at s = 0
  Axis axis_in_b_;
  Axis axis_in_a_;
  double angle_deg_ = 0;
  Vec3 slide_ = Vec3::Zero();  ///< in B
};

}  // namespace rubicon::collision
