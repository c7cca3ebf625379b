#pragma once

#include "src/collision/body.hpp"
#include "src/collision/convex.hpp"

namespace rubicon::collision {

/// A convex solid around everything a convex piece sweeps.
struct SweptPiece {
  ConvexPiece piece;
  double excess = 0;  ///< m, no point of it is farther than this from the swept volume
};

/// A part [s0, s1] of the motion of a body, by which its pieces are swept one by one: each gives
/// the hull of its two ends, grown by what its points stray from their chords (docs/collision.md,
/// Other machines). Exact for a translation, ball and disc included.
class PieceSlice {
 public:
  PieceSlice(const Body& body, const Motion& motion, double s0, double s1);

  /// The swept pieces are in world axes about this point, near the body (m, world).
  const Vec3& origin() const { return start_.t; }

  /// `growth` (m): how much of excess is meant to be allowed; decides how closely a disc that is
  /// tilted is followed.
  SweptPiece sweep(const Convex& piece, double growth) const;

 private:
  SweptPiece translated(const Convex& piece) const;
  SweptPiece turned(const Convex& piece, double growth) const;
  double sagitta(const std::vector<Vec3>& at_start, const std::vector<Vec3>& own) const;

  Vec3 at_start(const Vec3& own) const { return start_.R * own; }
  Vec3 at_end(const Vec3& own) const { return end_.R * own + shift_; }

  const Motion* motion_;
  BodyExtent extent_;
  double s0_;
  double s1_;
  Placement start_;
  Placement end_;
  Vec3 shift_;  ///< of the body's centre, from s0 to s1
};

}  // namespace rubicon::collision
