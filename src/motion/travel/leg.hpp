#pragma once

#include <optional>

#include "src/motion/travel/outline.hpp"

namespace rubicon::travel {

/// A straight way from a point.
class Leg {
 public:
  Leg(const ExactPoint& from, const Aim& aim);

  const ExactPoint& from() const { return from_; }
  /// A second point of its line, for exact sides.
  const ExactPoint& through() const { return through_; }
  const Aim& aim() const { return aim_; }
  const Vec2& direction() const { return direction_; }  ///< of length 1
  /// m; infinite along a direction.
  double length() const { return length_; }
  Vec2 at(double distance) const { return from_.p + distance * direction_; }
  double distance_of(const Vec2& p) const { return (p - from_.p).dot(direction_); }

 private:
  ExactPoint from_;
  ExactPoint through_;
  Aim aim_;
  Vec2 direction_{0, 0};
  double length_ = 0;
};

/// Where a leg meets the outline.
struct Hit {
  int composite = 0;
  int edge = 0;
  double along = 0;     ///< m from the start of the edge; 0: at its node
  double distance = 0;  ///< m from the start of the leg
  Vec2 point{0, 0};
};

/// The first point, from `begin` metres on, where a leg would enter an obstacle. Running along an
/// edge and past a corner is free; through a point where obstacles meet is not. `departing`: the
/// leg leaves an outline at `begin`, and the node there, if any, is known to let it. Exact.
std::optional<Hit> first_hit(const Outline& outline, const Leg& leg, double begin, bool departing);

}  // namespace rubicon::travel
