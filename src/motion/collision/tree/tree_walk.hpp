#pragma once

#include "src/motion/collision/tree/wide_node.hpp"

// Included by each unit that is compiled for one processor; everything is local to that unit.

namespace rubicon::collision {
namespace {

/// Writes the items of a tree (root: node 0) in the slots that `slots_meeting` names for each node
/// to `found`; their number, or -1 if there are more than `capacity`.
template <typename SlotsMeeting>
inline int walk(const WideNode* nodes, const SlotsMeeting& slots_meeting, int* found,
                int capacity) {
  int open[kMaxOpen];
  int open_count = 0;
  int count = 0;
  open[open_count++] = 0;
  while (open_count > 0) {
    const WideNode& node = nodes[open[--open_count]];
    for (unsigned mask = slots_meeting(node); mask != 0; mask &= mask - 1) {
      const int child = node.child[__builtin_ctz(mask)];
      if (child >= 0) {
        open[open_count++] = child;
      } else if (count < capacity) {
        found[count++] = ~child;
      } else {
        return -1;
      }
    }
  }
  return count;
}

}  // namespace
}  // namespace rubicon::collision
