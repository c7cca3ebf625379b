#pragma once

#include <cstdint>

// Plain data shared with the units that are compiled for one processor: nothing here may bring in
// Eigen or the standard library's templates, whose copies the linker could pick for everyone.

namespace rubicon::collision {

/// Children of a node of a `WideTree`.
inline constexpr int kWidth = 8;

/// Most entries the traversal of a tree of `kMaxDepth` levels can have open at once.
inline constexpr int kMaxDepth = 32;
inline constexpr int kMaxOpen = (kWidth - 1) * kMaxDepth + 1;

/// An axis-parallel box in single precision, rounded outwards.
struct FloatBox {
  float lower[3];
  float upper[3];
};

/// A convex region within an axis-parallel box, both relative to the tree's origin: the points p of
/// the box with |axis[j].p - middle[j]| <= half[j] for all j. The halves include a margin for all
/// rounding of the test in single precision.
struct FloatSlabs {
  static constexpr int kMost = 6;
  FloatBox box;
  int count = 0;
  float axis[kMost][3];
  float middle[kMost];
  float half[kMost];
};

/// Eight boxes side by side, so that one instruction tests all of them. An unused slot has an empty
/// box (lower > upper), which meets nothing.
struct alignas(64) WideNode {
  float lower[3][kWidth];
  float upper[3][kWidth];
  std::int32_t child[kWidth];  ///< a node's index, or ~item
  std::int32_t count[kWidth];  ///< items below the slot, 0: unused
};

}  // namespace rubicon::collision
