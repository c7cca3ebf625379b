#pragma once

#include "src/motion/collision/convex/convex.hpp"
#include "src/motion/collision/sweep/body.hpp"

namespace rubicon::collision {

/// A convex solid around everything a convex piece sweeps.
struct SweptPiece {
  ConvexPiece piece;
  double excess = 0;  ///< m, no point of it is farther than this from the swept volume
};

/// A part [s0, s1] of the motion of a body, by which its pieces are swept one by one: each gives
/// the hull of its two ends, grown by what its points deviate from their chords (docs/collision.md,
/// Other machines). Exact for a translation, ball and disc included. Body and motion must outlive
/// it.
class PieceSlice {
 public:
  PieceSlice(const Body& body, const Motion& motion, double s0, double s1);

  /// The swept pieces are in world axes about this point, near the body (m, world).
  const Vec3& origin() const { return start_.t; }

  /// A box around all that a box of the body sweeps, world.
  Bounds bounds(const Bounds& own) const;

  /// `growth` (m): how much of excess is meant to be allowed; decides how closely a disc that is
  /// tilted is followed.
  SweptPiece sweep(const Convex& piece, double growth) const;
  /// The piece where it is at s0.
  ConvexPiece standing(const Convex& piece) const;

 private:
  ConvexPiece translated(const Convex& piece, const Vec3& way) const;
  SweptPiece turned(const Convex& piece, double growth) const;
  double excess_estimate(const Convex& piece) const;
  double chord_deviation(double radius, double reach) const;
  double distance_from_axis(const Vec3& at_start) const;

  Vec3 at_start(const Vec3& own) const { return start_.R * own; }
  Vec3 at_end(const Vec3& own) const { return end_.R * own + shift_; }

  const BodyExtent& extent_;
  const Motion& motion_;
  const geometry::ScrewMotion* screw_;  ///< null: a general motion
  double s0_;
  double s1_;
  Placement start_;
  Placement end_;
  Vec3 shift_;  ///< of the body's centre, from s0 to s1
};

}  // namespace rubicon::collision
