#pragma once

#include "src/motion/math/lanes.hpp"

namespace rubicon::collision {

inline constexpr unsigned kAllIntervals = (1U << math::kLanes) - 1;

/// A box around a part of a body that goes along a leg, as the inner loops need it. Plain data.
struct LegPart {
  double R[3][3];       ///< of the box, in its frame
  double centre[3];     ///< m, in its frame
  double half[3];       ///< m
  double reach;         ///< m: no point of it is farther from the origin of its frame
  double acceleration;  ///< m: of any point of it, by the share of the leg
  int item;
  int frame;
  bool turned;  ///< R is not the identity
  bool exact;   ///< the part is this box
};

/// The same at the middles of four intervals of the leg. World.
struct LanePart {
  math::Lanes R[3][3];
  math::Lanes centre[3];  ///< m
  math::Lanes v[3];       ///< m, of the centre, by the share of the leg
  math::Lanes grown[3];   ///< m, half of the box that holds it in the whole interval, in its axes
  math::Lanes around[3];  ///< m, half of the box around that along the axes of the world
};

/// A box that stands. World.
struct StandingBox {
  double R[3][3];
  double centre[3];  ///< m
  double half[3];    ///< m
  double around[3];  ///< m, along the axes of the world
  int obstacle;      ///< index into the obstacles that were found
  bool exact;
};

/// Two parts of items that may not meet, as seen from a frame that carries both (-1: the world).
struct LegPair {
  int first;   ///< part
  int second;  ///< part
  int base;
  double of_first;  ///< m: acceleration of any point
  double of_second;
};

/// A part against a box that stands, or a pair.
struct LegCandidate {
  int part;       ///< -1: a pair
  int other;      ///< a standing box, or the pair
  unsigned open;  ///< bit i: not proved free in interval i
  unsigned met;   ///< bit i: deeper in each other than the tolerance, in the middle of interval i
};

/// Four intervals of a leg.
struct LegIntervals {
  double half;    ///< of each, as a share of the leg
  double margin;  ///< m
  double deep;    ///< m: boxes so deep in each other meet
  const math::LaneFrame* frames;
};

/// The inner loops. All forms do the same operations in the same order on each number.
struct LegKernels {
  void (*place)(const LegIntervals& intervals, const LegPart& part, LanePart& placed);
  /// Bit i: the boxes of two parts along the axes of the world meet in interval i.
  unsigned (*near)(const LanePart& a, const LanePart& b);
  /// Looks at candidates; those that are open in an interval that they were open in are kept at the
  /// front. Their number.
  int (*look)(const LegIntervals& intervals, const LegPart* parts, const LanePart* placed,
              const StandingBox* standing, const LegPair* pairs, LegCandidate* candidates,
              int count);
};

/// The form for what is in use (`use_simd`).
const LegKernels& leg_kernels();

}  // namespace rubicon::collision
