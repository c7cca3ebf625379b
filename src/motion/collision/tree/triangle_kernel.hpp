#pragma once

#include "src/motion/collision/tree/triangle_pack.hpp"

// The separating axes of a swept box and four triangles at once (Akenine-Moeller 2001, with the
// displacement x edge axes of docs/collision.md). Included by each unit that is compiled for one
// processor; everything is local to that unit. The operations on each triangle and their order do
// not depend on the processor.

namespace rubicon::collision {
namespace {

typedef double Four __attribute__((vector_size(kPack * sizeof(double))));
using FourBits = decltype(Four{} < Four{});

#define RUBICON_INLINE inline __attribute__((always_inline))

struct FourVectors {
  Four x, y, z;
};

RUBICON_INLINE Four all(double value) { return Four{value, value, value, value}; }
RUBICON_INLINE Four least(Four a, Four b) { return a < b ? a : b; }
RUBICON_INLINE Four greatest(Four a, Four b) { return a > b ? a : b; }
RUBICON_INLINE Four magnitude(Four a) { return a < 0 ? -a : a; }
RUBICON_INLINE Four root(Four a) {
#if defined(__AVX2__)
  return (Four)_mm256_sqrt_pd((__m256d)a);
#else
  Four result = a;
  for (int i = 0; i < kPack; ++i) result[i] = __builtin_sqrt(a[i]);
  return result;
#endif
}
RUBICON_INLINE Four dot(const FourVectors& a, const FourVectors& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
RUBICON_INLINE Four dot(const FourVectors& a, const double* b) {
  return a.x * b[0] + a.y * b[1] + a.z * b[2];
}
RUBICON_INLINE FourVectors cross(const FourVectors& a, const FourVectors& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
RUBICON_INLINE FourVectors difference(const FourVectors& a, const FourVectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
RUBICON_INLINE FourVectors same(const double* v) { return {all(v[0]), all(v[1]), all(v[2])}; }

/// Whole, not number by number: what is put together from parts waits for them in memory.
RUBICON_INLINE Four load(const double* values) {
  Four result;
  __builtin_memcpy(&result, values, sizeof(result));
  return result;
}

RUBICON_INLINE FourVectors load(const double (*corner)[kPack]) {
  return {load(corner[0]), load(corner[1]), load(corner[2])};
}

RUBICON_INLINE FourVectors moved(const BoxPass& box, const FourVectors& p) {
  return {p.x * box.to_box[0][0] + p.y * box.to_box[0][1] + p.z * box.to_box[0][2] + box.offset[0],
          p.x * box.to_box[1][0] + p.y * box.to_box[1][1] + p.z * box.to_box[1][2] + box.offset[1],
          p.x * box.to_box[2][0] + p.y * box.to_box[2][1] + p.z * box.to_box[2][2] + box.offset[2]};
}

RUBICON_INLINE unsigned bits(FourBits mask) {
#if defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_pd((__m256d)mask));
#else
  return (mask[0] != 0 ? 1U : 0U) | (mask[1] != 0 ? 2U : 0U) | (mask[2] != 0 ? 4U : 0U) |
         (mask[3] != 0 ? 8U : 0U);
#endif
}

RUBICON_INLINE Four reach(const BoxPass& box, const double (*axes)[3], const FourVectors& n) {
  return box.half[0] * magnitude(dot(n, axes[0])) + box.half[1] * magnitude(dot(n, axes[1])) +
         box.half[2] * magnitude(dot(n, axes[2]));
}

/// Squared lengths of axes below this share of what they could be are rounding alone.
inline constexpr double kNoAxis = 1e-24;

/// Ways below this (m2, squared) have no direction: products of theirs would vanish in rounding.
inline constexpr double kNoWay = 1e-100;

/// Where a gap along an axis of this squared length is no deeper than the tolerance.
RUBICON_INLINE FourBits near_enough(Four gap, Four tolerance, Four squared) {
  return (gap >= 0) | (gap * gap <= tolerance * tolerance * squared);
}

/// Which triangles are apart from the box along n, which need not be of unit length; `scale` is the
/// square of the length it could have.
RUBICON_INLINE FourBits apart(const BoxPass& box, const FourVectors* corners, Four tolerance,
                              const FourVectors& n, Four scale) {
  const Four a = dot(n, corners[0]);
  const Four b = dot(n, corners[1]);
  const Four c = dot(n, corners[2]);
  const Four lower = least(a, least(b, c));
  const Four upper = greatest(a, greatest(b, c));
  const Four at_start = dot(n, box.start);
  const Four at_end = dot(n, box.end);
  const Four squared = dot(n, n);
  Four gap;
  if (box.same_axes) {
    const Four own =
        box.half[0] * magnitude(n.x) + box.half[1] * magnitude(n.y) + box.half[2] * magnitude(n.z);
    gap = greatest(least(at_start, at_end) - own - upper, lower - greatest(at_start, at_end) - own);
  } else {
    const Four start = reach(box, box.start_axes, n);
    const Four end = reach(box, box.end_axes, n);
    gap = greatest(least(at_start - start, at_end - end) - upper,
                   lower - greatest(at_start + start, at_end + end));
    // Growth only makes it less: most axes need no square roots.
    const FourBits possible = near_enough(gap, tolerance, squared);
    if (bits(possible) == 0) return possible;
    const FourVectors across = cross(n, same(box.growth_axis));
    gap -= box.axial_growth * root(dot(across, across)) + box.uniform_growth * root(squared);
  }
  return near_enough(gap, tolerance, squared) & (squared > kNoAxis * scale);
}

/// Which of the four triangles the box may meet by more than the tolerance (bit i: triangle i). For
/// a translation exactly those; for a rotation those not proved free.
inline unsigned meeting_triangles(const BoxPass& box, const TrianglePack& pack) {
  const FourVectors corners[3] = {moved(box, load(pack.corner[0])),
                                  moved(box, load(pack.corner[1])),
                                  moved(box, load(pack.corner[2]))};
  const Four tolerance = least(load(pack.tolerance), all(box.tolerance));

  const auto along = [&](Four a, Four b, Four c, int axis) {
    const Four lower = least(a, least(b, c));
    const Four upper = greatest(a, greatest(b, c));
    return (box.upper[axis] - lower <= tolerance) | (upper - box.lower[axis] <= tolerance);
  };
  FourBits free = along(corners[0].x, corners[1].x, corners[2].x, 0) |
                  along(corners[0].y, corners[1].y, corners[2].y, 1) |
                  along(corners[0].z, corners[1].z, corners[2].z, 2);
  if (bits(free) == 15U) return 0;

  const FourVectors edges[3] = {difference(corners[1], corners[0]),
                                difference(corners[2], corners[1]),
                                difference(corners[0], corners[2])};
  Four lengths[3];
  for (int i = 0; i < 3; ++i) lengths[i] = dot(edges[i], edges[i]);
  free |= apart(box, corners, tolerance, cross(edges[0], edges[1]), lengths[0] * lengths[1]);
  if (bits(free) == 15U) return 0;

  const Four zero = all(0);
  for (int i = 0; i < 3; ++i) {
    const FourVectors& e = edges[i];
    free |= apart(box, corners, tolerance, {zero, -e.z, e.y}, lengths[i]);
    free |= apart(box, corners, tolerance, {e.z, zero, -e.x}, lengths[i]);
    free |= apart(box, corners, tolerance, {-e.y, e.x, zero}, lengths[i]);
    if (bits(free) == 15U) return 0;
  }

  const double d[3] = {box.end[0] - box.start[0], box.end[1] - box.start[1],
                       box.end[2] - box.start[2]};
  const double way = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  if (way > kNoWay) {
    const FourVectors displacement = same(d);
    for (int i = 0; i < 3; ++i) {
      free |= apart(box, corners, tolerance, cross(displacement, edges[i]), lengths[i] * way);
    }
    if (bits(free) == 15U) return 0;
    const double across[3][3] = {{0, d[2], -d[1]}, {-d[2], 0, d[0]}, {d[1], -d[0], 0}};
    for (int i = 0; i < 3; ++i) {
      free |= apart(box, corners, tolerance, same(across[i]), all(way));
    }
  }
  return ~bits(free) & ((1U << pack.count) - 1U);
}

/// Which triangles are apart from the moving one along n, which need not be of unit length; `scale`
/// is the square of the length it could have.
RUBICON_INLINE FourBits apart(const TrianglePass& moving, const FourVectors* corners,
                              Four tolerance, const FourVectors& n, Four scale) {
  const Four a = dot(n, corners[0]);
  const Four b = dot(n, corners[1]);
  const Four c = dot(n, corners[2]);
  Four own_lower = dot(n, moving.start[0]);
  Four own_upper = own_lower;
  for (int i = 0; i < 3; ++i) {
    const Four at_start = dot(n, moving.start[i]);
    const Four at_end = dot(n, moving.end[i]);
    own_lower = least(own_lower, least(at_start, at_end));
    own_upper = greatest(own_upper, greatest(at_start, at_end));
  }
  const Four squared = dot(n, n);
  Four gap = greatest(own_lower - greatest(a, greatest(b, c)), least(a, least(b, c)) - own_upper);
  if (moving.axial_growth > 0 || moving.uniform_growth > 0) {
    const FourBits possible = near_enough(gap, tolerance, squared);
    if (bits(possible) == 0) return possible;
    const FourVectors across = cross(n, same(moving.growth_axis));
    gap -= moving.axial_growth * root(dot(across, across)) + moving.uniform_growth * root(squared);
  }
  return near_enough(gap, tolerance, squared) & (squared > kNoAxis * scale);
}

/// The same for a moving triangle: both normals, edge x edge, displacement x edge.
inline unsigned met_by_triangle(const TrianglePass& moving, const TrianglePack& pack) {
  const FourVectors corners[3] = {load(pack.corner[0]), load(pack.corner[1]), load(pack.corner[2])};
  const Four tolerance = least(load(pack.tolerance), all(moving.tolerance));
  const Four zero = all(0);
  const Four one = all(1);
  FourBits free = apart(moving, corners, tolerance, {one, zero, zero}, one) |
                  apart(moving, corners, tolerance, {zero, one, zero}, one) |
                  apart(moving, corners, tolerance, {zero, zero, one}, one);
  if (bits(free) == 15U) return 0;

  const FourVectors edges[3] = {difference(corners[1], corners[0]),
                                difference(corners[2], corners[1]),
                                difference(corners[0], corners[2])};
  const FourVectors own_edges[3] = {same(moving.edges[0]), same(moving.edges[1]),
                                    same(moving.edges[2])};
  Four lengths[3];
  Four own_lengths[3];
  for (int i = 0; i < 3; ++i) {
    lengths[i] = dot(edges[i], edges[i]);
    own_lengths[i] = dot(own_edges[i], own_edges[i]);
  }
  free |= apart(moving, corners, tolerance, cross(edges[0], edges[1]), lengths[0] * lengths[1]);
  free |= apart(moving, corners, tolerance, cross(own_edges[0], own_edges[1]),
                own_lengths[0] * own_lengths[1]);
  if (bits(free) == 15U) return 0;

  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      free |= apart(moving, corners, tolerance, cross(own_edges[i], edges[j]),
                    own_lengths[i] * lengths[j]);
    }
    if (bits(free) == 15U) return 0;
  }

  double d[3];
  for (int axis = 0; axis < 3; ++axis) {
    d[axis] = (moving.end[0][axis] - moving.start[0][axis]) +
              (moving.end[1][axis] - moving.start[1][axis]) +
              (moving.end[2][axis] - moving.start[2][axis]);
  }
  const double way = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  if (way > kNoWay) {
    const FourVectors displacement = same(d);
    for (int i = 0; i < 3; ++i) {
      free |= apart(moving, corners, tolerance, cross(displacement, edges[i]), lengths[i] * way);
      free |= apart(moving, corners, tolerance, cross(displacement, own_edges[i]),
                    own_lengths[i] * way);
    }
  }
  return ~bits(free) & ((1U << pack.count) - 1U);
}

#undef RUBICON_INLINE

}  // namespace
}  // namespace rubicon::collision
