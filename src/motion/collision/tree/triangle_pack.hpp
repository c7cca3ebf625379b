#pragma once

#include "src/motion/collision/tree/wide_node.hpp"

// Plain data shared with the units that are compiled for one processor, see wide_node.hpp.

namespace rubicon::collision {

/// Triangles of a pack.
inline constexpr int kPack = 4;

/// Four triangles side by side; a pack of fewer repeats its first one.
struct alignas(32) TrianglePack {
  double corner[3][3][kPack];  ///< [corner][axis][triangle], m
  double tolerance[kPack];     ///< m, the most a triangle of this size allows
  std::int32_t first = 0;      ///< of the soup's triangles
  std::int32_t count = 0;
};

/// A box that moves past triangles, in the frame of the box at the middle of the interval (its axes
/// are the coordinate axes, its centre the origin).
struct BoxPass {
  double to_box[3][3];  ///< from the frame of the triangles: p' = to_box p + offset
  double offset[3];
  double half[3];
  double start_axes[3][3];  ///< [axis of the box][coordinate] at the start
  double end_axes[3][3];
  double start[3];  ///< centre at the start
  double end[3];
  double lower[3];  ///< the swept box along its middle axes, growth included
  double upper[3];
  double growth_axis[3];
  double axial_growth = 0;    ///< m, docs/collision.md
  double uniform_growth = 0;  ///< m
  double tolerance = 0;       ///< m, the most the box allows
  bool same_axes = false;     ///< a translation: start_axes and end_axes are the coordinate axes
};

/// A triangle that moves past others, in their frame.
struct TrianglePass {
  double start[3][3];  ///< [corner][axis]
  double end[3][3];
  double edges[3][3];  ///< at the middle of the interval
  double growth_axis[3];
  double axial_growth = 0;    ///< m
  double uniform_growth = 0;  ///< m
  double tolerance = 0;       ///< m, the most this triangle allows
};

}  // namespace rubicon::collision
