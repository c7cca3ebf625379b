#pragma once

#include "src/motion/collision/convex/convex.hpp"

namespace rubicon::collision {

/// Two convex solids over one interval of a motion, in the frame of the one that is taken as fixed.
/// The other lies at all times inside the hull of its poses `start` and `end`, grown along a unit
/// direction n by `growth(n)`.
struct SweptPair {
  Convex moving;
  Convex fixed;
  Placement start;
  Placement middle;
  Placement end;
  bool standing = false;  ///< no motion: `start` is the only pose that counts
  Vec3 growth_axis = Vec3::UnitZ();
  double axial_growth = 0;    ///< m, sagitta of arcs about `growth_axis`; none along that axis
  double uniform_growth = 0;  ///< m, the same in every direction
  double tolerance = 0;       ///< m

  /// From now on the moving one stands at `pose`.
  void stand_at(const Placement& pose) {
    standing = true;
    start = middle = end = pose;
  }

  double growth(const Vec3& n) const;

  /// How deep the two overlap along the unit vector n, that is how far the fixed one would have to
  /// be pushed along n to have the swept one behind it; negative where they are apart. Ball radii
  /// and growth included.
  double overlap(const Vec3& n) const;
  /// Whether n or -n shows an overlap of at most the tolerance: a proof that the interval is free.
  bool free_along(const Vec3& n) const;

  /// Point farthest along n of the set {a - b: a in the core of the swept one, b in the core of the
  /// fixed one}.
  Vec3 difference_support(const Vec3& n) const;
  /// The two core points whose difference that is.
  struct Support {
    Vec3 moving = Vec3::Zero();
    Vec3 fixed = Vec3::Zero();
  };
  Support support(const Vec3& n) const;
  double balls() const { return moving.ball + fixed.ball; }
};

}  // namespace rubicon::collision
