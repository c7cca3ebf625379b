#pragma once

#include "src/motion/collision/tree/triangle_pack.hpp"
#include "src/motion/collision/tree/wide_node.hpp"

// Included by the units that are compiled for one processor: plain data only, see wide_node.hpp.

namespace rubicon::collision {

/// The inner loops, in the form that suits the processor. All forms do the same operations in the
/// same order on each number, so their answers are the same bit by bit.
struct Kernels {
  /// Writes the items of a tree (root: node 0) whose boxes meet `box` to `found`; their number, or
  /// -1 if there are more than `capacity`.
  int (*collect)(const WideNode* nodes, const FloatBox& box, int* found, int capacity);
  /// The same for a region between slabs; of the items whose boxes meet its box, those are left out
  /// that lie beside one of the slabs.
  int (*collect_between)(const WideNode* nodes, const FloatSlabs& slabs, int* found, int capacity);
  /// Which triangles of a pack a moving box may meet by more than the tolerance (bit i: triangle
  /// i). For a translation exactly those; for a rotation those not proved free.
  unsigned (*meeting_triangles)(const BoxPass& box, const TrianglePack& pack);
  /// The same for a moving triangle.
  unsigned (*met_by_triangle)(const TrianglePass& moving, const TrianglePack& pack);
};

/// Plain C++; the reference.
const Kernels& baseline_kernels();
/// For processors with AVX2, null where the compiler cannot make them.
const Kernels* avx2_kernels();
/// Those in use (`use_simd`).
const Kernels& kernels();

}  // namespace rubicon::collision
