#pragma once

#include <memory>
#include <vector>

#include "src/motion/collision/base/bounds.hpp"
#include "src/motion/collision/swept_query.hpp"

namespace rubicon::collision {

class Sweep;

/// The moving bodies of a query, made ready once to be tested against swept volumes. The query must
/// outlive it. Throws std::invalid_argument for motions that are not valid.
class MovingBodies {
 public:
  explicit MovingBodies(const SweptQuery& query);
  ~MovingBodies();
  MovingBodies(const MovingBodies&) = delete;
  MovingBodies& operator=(const MovingBodies&) = delete;

  int count() const { return static_cast<int>(sweeps_.size()); }
  /// The box around all that they sweep, world.
  const Bounds& bounds() const { return bounds_; }
  /// The box around what they sweep in the part [s0, s1] of their motions, world.
  Bounds bounds_between(double s0, double s1) const;

 private:
  friend class SweptVolume;

  double contact_tolerance_;
  std::vector<std::unique_ptr<Sweep>> sweeps_;  ///< one an item of the query
  Bounds bounds_;
};

/// The whole volume that a body sweeps in a motion, as an obstacle: what meets it meets the body at
/// some moment of the motion. Never less than that volume, and more by at most `growth` (m); exact
/// for translations. It is looked at in slices that are made where something comes near, and kept:
/// for one thread at a time, and the answers do not depend on what was asked before.
/// docs/collision.md, Other machines.
class SweptVolume {
 public:
  /// Throws std::invalid_argument for motions that are not valid.
  SweptVolume(BodyPtr body, Motion motion, double growth);
  ~SweptVolume();
  SweptVolume(SweptVolume&&) noexcept;
  SweptVolume& operator=(SweptVolume&&) noexcept;

  /// The box around it, world.
  const Bounds& bounds() const;
  /// Whether one of the moving bodies meets it somewhere on its way, deeper than the contact
  /// tolerance of its query; widths are those of the bodies' own pieces.
  bool meets(MovingBodies& bodies, int item) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rubicon::collision
