#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "src/motion/travel/wide.hpp"

namespace rubicon::travel {

using Vec2 = Eigen::Vector2d;  ///< a point or direction in the plan view, m, x east and y north

/// How many pitches of the lattice of corners make a metre: a pitch is 0.95 um. Corners are moved
/// by up to half of it. A power of two, so that lengths in whole multiples of 1/1024 m stay exact.
inline constexpr double kPitchesPerMetre = 1 << 20;
/// Corners lie within this many metres of the origin in x and y: then all predicates fit in 384
/// bits. A little more than 524 km.
inline constexpr double kReach = 1 << 19;

/// A corner as the predicates see it: whole pitches.
struct LatticePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

/// The corner next to `p`. Throws std::invalid_argument where p is not finite or out of reach.
LatticePoint snap(const Vec2& p);
/// In metres, without error.
Vec2 metres(const LatticePoint& p);

/// A point (x/w, y/w) in pitches, w > 0: a corner, or where two lines through corners cross.
struct ExactPoint {
  Int128 x = 0;
  Int128 y = 0;
  Int128 w = 1;
  Vec2 p{0, 0};  ///< the same in metres, rounded: what lengths are computed with

  ExactPoint() = default;
  ExactPoint(const LatticePoint& corner);  // NOLINT: a corner is a point
};

/// The point of binary fractions next to `p`, at most 2^-42 m from it.
ExactPoint nearby(const Vec2& p);

/// Twice the area of a, b, c, and its sign: 1 where c is left of the way from a to b.
Int128 area(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);
int side(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);
/// On which side of the way from a to b point c is: 1 left, -1 right, 0 on the line. Exact.
int side(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
/// The sign of the cross product of b - a and d - c: 1 where c to d runs left of a to b.
int turn(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
         const LatticePoint& d);

/// Where a straight way leads: to a corner, or for ever along a direction (whose coordinates are
/// not both 0).
struct Aim {
  LatticePoint to;
  bool is_direction = false;
};
/// The sign of the cross product of b - a with the way to the aim from any point of the line a b: 1
/// where it leads to the left.
int side(const LatticePoint& a, const LatticePoint& b, const Aim& aim);

/// Order by x, then y: -1, 0 or 1. Exact.
int compare(const ExactPoint& a, const ExactPoint& b);
/// By y alone.
int compare_y(const ExactPoint& a, const ExactPoint& b);

/// Where the lines a b and c d, which are not parallel, cross.
ExactPoint crossing(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                    const LatticePoint& d);
/// The foot of the perpendicular from c on the line a b.
ExactPoint foot(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);

/// Where the middle between a and b is with regard to a ring of corners: 1 inside, 0 on it, -1
/// outside. Exact; the middle of a point with itself is the point.
int place_of_middle(const ExactPoint& a, const ExactPoint& b,
                    const std::vector<LatticePoint>& ring);

}  // namespace rubicon::travel
