#include "src/motion/collision/query/leg_kernels.hpp"

#include "src/motion/collision/swept_query.hpp"

namespace rubicon::collision {

namespace {

using math::LaneFrame;
using math::LaneMask;
using math::Lanes;
using math::lanes;

/// Cross products of unit vectors whose squares are shorter than this have no direction left.
constexpr double kParallelEdges = 1e-4;

RUBICON_LANES Lanes dot(const Lanes (&R)[3][3], int column, const Lanes (&v)[3]) {
  return R[0][column] * v[0] + R[1][column] * v[1] + R[2][column] * v[2];
}

/// Half of the box, in its own axes, that holds a box in a whole interval: no point is farther from
/// where it is in the middle than its velocity there by half of the interval, and what it
/// accelerates. For a box that turns at w each point at r from the centre has the velocity w x r.
RUBICON_LANES void grow(const LegIntervals& intervals, const double (&half)[3], double acceleration,
                        const Lanes (&R)[3][3], const Lanes (&v)[3], const Lanes (&w)[3],
                        Lanes (&grown)[3]) {
  const Lanes h = lanes(intervals.half);
  const Lanes more = lanes(0.5 * intervals.half * intervals.half * acceleration + intervals.margin);
  Lanes turning[3];
  for (int j = 0; j < 3; ++j) turning[j] = math::abs(dot(R, j, w));
  for (int j = 0; j < 3; ++j) {
    const int k = (j + 1) % 3;
    const int l = (j + 2) % 3;
    const Lanes speed =
        math::abs(dot(R, j, v)) + turning[k] * lanes(half[l]) + turning[l] * lanes(half[k]);
    grown[j] = lanes(half[j]) + h * speed + more;
  }
}

RUBICON_LANES void place_part(const LegIntervals& intervals, const LegPart& part,
                              LanePart& placed) {
  const LaneFrame& X = intervals.frames[part.frame];
  Lanes arm[3];
  for (int i = 0; i < 3; ++i) {
    arm[i] = X.R[i][0] * lanes(part.centre[0]) + X.R[i][1] * lanes(part.centre[1]) +
             X.R[i][2] * lanes(part.centre[2]);
    placed.centre[i] = X.t[i] + arm[i];
    for (int j = 0; j < 3; ++j) {
      placed.R[i][j] = part.turned
                           ? X.R[i][0] * lanes(part.R[0][j]) + X.R[i][1] * lanes(part.R[1][j]) +
                                 X.R[i][2] * lanes(part.R[2][j])
                           : X.R[i][j];
    }
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    placed.v[i] = X.v[i] + (X.w[j] * arm[k] - X.w[k] * arm[j]);
  }
  grow(intervals, part.half, part.acceleration, placed.R, placed.v, X.w, placed.grown);
  for (int i = 0; i < 3; ++i) {
    placed.around[i] = math::abs(placed.R[i][0]) * placed.grown[0] +
                       math::abs(placed.R[i][1]) * placed.grown[1] +
                       math::abs(placed.R[i][2]) * placed.grown[2];
  }
}

RUBICON_LANES Lanes all_lanes(double x) { return lanes(x); }
RUBICON_LANES const Lanes& all_lanes(const Lanes& x) { return x; }

/// A box of four lanes: half in its own axes.
struct LaneBox {
  const Lanes (&R)[3][3];
  const Lanes (&centre)[3];
  RUBICON_LANES Lanes axis(int row, int column) const { return R[row][column]; }
  RUBICON_LANES Lanes middle(int row) const { return centre[row]; }
};

struct OneBox {
  const double (&R)[3][3];
  const double (&centre)[3];
  RUBICON_LANES Lanes axis(int row, int column) const { return lanes(R[row][column]); }
  RUBICON_LANES Lanes middle(int row) const { return lanes(centre[row]); }
};

/// How two boxes lie to each other: the axes of b, and its centre, as a sees them.
struct Between {
  Lanes R[3][3];
  Lanes R_abs[3][3];
  Lanes t[3];
  Lanes u[3];  ///< t in the axes of b
};

template <class A, class B>
RUBICON_LANES void set(Between& between, const A& a, const B& b) {
  Lanes d[3];
  for (int k = 0; k < 3; ++k) d[k] = b.middle(k) - a.middle(k);
  for (int i = 0; i < 3; ++i) {
    between.t[i] = a.axis(0, i) * d[0] + a.axis(1, i) * d[1] + a.axis(2, i) * d[2];
    between.u[i] = b.axis(0, i) * d[0] + b.axis(1, i) * d[1] + b.axis(2, i) * d[2];
    for (int j = 0; j < 3; ++j) {
      between.R[i][j] =
          a.axis(0, i) * b.axis(0, j) + a.axis(1, i) * b.axis(1, j) + a.axis(2, i) * b.axis(2, j);
      between.R_abs[i][j] = math::abs(between.R[i][j]);
    }
  }
}

/// The square of the length of a product of two edges, and how far the boxes are apart along it by
/// that length; negative: they overlap.
struct EdgeGap {
  Lanes square;
  Lanes apart;
};
RUBICON_LANES EdgeGap edge_gap(const Between& is, const Lanes (&a)[3], const Lanes (&b)[3], int i,
                               int j) {
  const int i1 = (i + 1) % 3;
  const int i2 = (i + 2) % 3;
  const int j1 = (j + 1) % 3;
  const int j2 = (j + 2) % 3;
  const Lanes reach = a[i1] * is.R_abs[i2][j] + a[i2] * is.R_abs[i1][j] + b[j1] * is.R_abs[i][j2] +
                      b[j2] * is.R_abs[i][j1];
  return {lanes(1) - is.R[i][j] * is.R[i][j],
          math::abs(is.t[i2] * is.R[i1][j] - is.t[i1] * is.R[i2][j]) - reach};
}

RUBICON_LANES Lanes gap_along_a(const Between& is, const Lanes (&a)[3], const Lanes (&b)[3],
                                int i) {
  return math::abs(is.t[i]) -
         (a[i] + is.R_abs[i][0] * b[0] + is.R_abs[i][1] * b[1] + is.R_abs[i][2] * b[2]);
}

RUBICON_LANES Lanes gap_along_b(const Between& is, const Lanes (&a)[3], const Lanes (&b)[3],
                                int j) {
  return math::abs(is.u[j]) -
         (b[j] + is.R_abs[0][j] * a[0] + is.R_abs[1][j] * a[1] + is.R_abs[2][j] * a[2]);
}

/// In which of the lanes of `open` no axis parts the boxes.
RUBICON_LANES unsigned not_apart(const Between& is, const Lanes (&a)[3], const Lanes (&b)[3],
                                 unsigned open) {
  const Lanes zero = lanes(0);
  LaneMask apart = math::no_lane();
  for (int i = 0; i < 3; ++i) apart = apart | (gap_along_b(is, a, b, i) > zero);
  for (int i = 0; i < 3; ++i) apart = apart | (gap_along_a(is, a, b, i) > zero);
  open &= ~math::bits(apart);
  if (open == 0) return 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const EdgeGap edge = edge_gap(is, a, b, i, j);
      apart = apart | ((edge.apart > zero) & (edge.square > lanes(kParallelEdges)));
    }
  }
  return open & ~math::bits(apart);
}

/// In which of the lanes of `open` the boxes overlap deeper than that along all axes.
RUBICON_LANES unsigned deeper(const Between& is, const Lanes (&a)[3], const Lanes (&b)[3],
                              double depth, unsigned open) {
  const Lanes least = lanes(-depth);
  LaneMask shallow = math::no_lane();
  for (int i = 0; i < 3; ++i) {
    shallow = shallow | ~(least > gap_along_a(is, a, b, i)) | ~(least > gap_along_b(is, a, b, i));
  }
  open &= ~math::bits(shallow);
  if (open == 0) return 0;
  const Lanes square_of_least = lanes(depth * depth);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const EdgeGap edge = edge_gap(is, a, b, i, j);
      const LaneMask deep =
          (lanes(0) > edge.apart) & (edge.apart * edge.apart > square_of_least * edge.square);
      shallow = shallow | (~deep & (edge.square > lanes(kParallelEdges)));
    }
  }
  return open & ~math::bits(shallow);
}

RUBICON_LANES void spread(const double (&of)[3], Lanes (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = lanes(of[i]);
}

/// In which of the lanes of `open` boxes along the axes of the world meet.
template <class Box>
RUBICON_LANES unsigned near(const LanePart& at, const Box& other, unsigned open) {
  LaneMask apart = math::no_lane();
  for (int i = 0; i < 3; ++i) {
    apart = apart | (math::abs(at.centre[i] - all_lanes(other.centre[i])) >
                     at.around[i] + all_lanes(other.around[i]));
  }
  return open & ~math::bits(apart);
}

RUBICON_LANES void look_at_standing(const LegIntervals& intervals, const LegPart& part,
                                    const LanePart& at, const StandingBox& box,
                                    LegCandidate& candidate) {
  candidate.open = near(at, box, candidate.open);
  candidate.met = 0;
  if (candidate.open == 0) return;
  Between between;
  set(between, LaneBox{at.R, at.centre}, OneBox{box.R, box.centre});
  Lanes half[3];
  spread(box.half, half);
  candidate.open = not_apart(between, at.grown, half, candidate.open);
  if (candidate.open == 0 || !part.exact || !box.exact) return;
  Lanes own[3];
  spread(part.half, own);
  candidate.met = deeper(between, own, half, intervals.deep, candidate.open);
}

/// How a part moves as seen from a frame.
RUBICON_LANES void grow_in(const LegIntervals& intervals, const LegPart& part, const LanePart& at,
                           const LaneFrame* base, double acceleration, Lanes (&grown)[3]) {
  const LaneFrame& X = intervals.frames[part.frame];
  Lanes v[3];
  Lanes w[3];
  for (int i = 0; i < 3; ++i) {
    v[i] = at.v[i];
    w[i] = X.w[i];
  }
  if (base != nullptr) {
    Lanes arm[3];
    for (int i = 0; i < 3; ++i) arm[i] = at.centre[i] - base->t[i];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      v[i] = v[i] - base->v[i] - (base->w[j] * arm[k] - base->w[k] * arm[j]);
      w[i] = w[i] - base->w[i];
    }
  }
  grow(intervals, part.half, acceleration, at.R, v, w, grown);
}

RUBICON_LANES void look_at_pair(const LegIntervals& intervals, const LegPart* parts,
                                const LanePart* placed, const LegPair& pair,
                                LegCandidate& candidate) {
  const LegPart& first = parts[pair.first];
  const LegPart& second = parts[pair.second];
  const LanePart& a = placed[pair.first];
  const LanePart& b = placed[pair.second];
  candidate.open = near(a, b, candidate.open);
  candidate.met = 0;
  if (candidate.open == 0) return;
  const LaneFrame* base = pair.base < 0 ? nullptr : intervals.frames + pair.base;
  Lanes of_first[3];
  Lanes of_second[3];
  grow_in(intervals, first, a, base, pair.of_first, of_first);
  grow_in(intervals, second, b, base, pair.of_second, of_second);
  Between between;
  set(between, LaneBox{a.R, a.centre}, LaneBox{b.R, b.centre});
  candidate.open = not_apart(between, of_first, of_second, candidate.open);
  if (candidate.open == 0 || !first.exact || !second.exact) return;
  spread(first.half, of_first);
  spread(second.half, of_second);
  candidate.met = deeper(between, of_first, of_second, intervals.deep, candidate.open);
}

RUBICON_LANES int look_at_all(const LegIntervals& intervals, const LegPart* parts,
                              const LanePart* placed, const StandingBox* standing,
                              const LegPair* pairs, LegCandidate* candidates, int count) {
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    LegCandidate candidate = candidates[i];
    if (candidate.part >= 0) {
      look_at_standing(intervals, parts[candidate.part], placed[candidate.part],
                       standing[candidate.other], candidate);
    } else {
      look_at_pair(intervals, parts, placed, pairs[candidate.other], candidate);
    }
    if (candidate.open != 0) candidates[kept++] = candidate;
  }
  return kept;
}

void place_baseline(const LegIntervals& intervals, const LegPart& part, LanePart& placed) {
  place_part(intervals, part, placed);
}

unsigned near_baseline(const LanePart& a, const LanePart& b) { return near(a, b, kAllIntervals); }

int look_baseline(const LegIntervals& intervals, const LegPart* parts, const LanePart* placed,
                  const StandingBox* standing, const LegPair* pairs, LegCandidate* candidates,
                  int count) {
  return look_at_all(intervals, parts, placed, standing, pairs, candidates, count);
}

RUBICON_AVX2 void place_avx2(const LegIntervals& intervals, const LegPart& part, LanePart& placed) {
  place_part(intervals, part, placed);
}

RUBICON_AVX2 unsigned near_avx2(const LanePart& a, const LanePart& b) {
  return near(a, b, kAllIntervals);
}

RUBICON_AVX2 int look_avx2(const LegIntervals& intervals, const LegPart* parts,
                           const LanePart* placed, const StandingBox* standing,
                           const LegPair* pairs, LegCandidate* candidates, int count) {
  return look_at_all(intervals, parts, placed, standing, pairs, candidates, count);
}

}  // namespace

const LegKernels& leg_kernels() {
  static const LegKernels baseline{place_baseline, near_baseline, look_baseline};
  static const LegKernels avx2{place_avx2, near_avx2, look_avx2};
  return simd_in_use() == Simd::kAvx2 ? avx2 : baseline;
}

}  // namespace rubicon::collision
