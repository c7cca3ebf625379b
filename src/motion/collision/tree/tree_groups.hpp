#pragma once

#include <cstddef>
#include <vector>

#include "src/motion/collision/tree/wide_node.hpp"

namespace rubicon::collision {

/// An item of a tree that is built, and its box.
struct TreeEntry {
  FloatBox box;
  int item = 0;
};

/// A run of entries that one child is made of.
struct TreeGroup {
  std::size_t begin = 0;
  std::size_t end = 0;
  double area = 0;

  std::size_t size() const { return end - begin; }
};

/// Splits the entries from `begin` to `end` into up to eight runs, sorting them: the largest is cut
/// until there are eight or each fits into one node. Cuts by the surface area heuristic with bins
/// (Wald 2007), or into halves `by_number`.
std::vector<TreeGroup> tree_groups(std::vector<TreeEntry>& entries, std::size_t begin,
                                   std::size_t end, bool by_number);

}  // namespace rubicon::collision
