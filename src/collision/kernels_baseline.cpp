#include "src/collision/kernels.hpp"
#include "src/collision/triangle_kernel.hpp"

namespace rubicon::collision {
namespace {

unsigned meeting_slots(const WideNode& node, const FloatBox& box) {
  unsigned mask = 0;
  for (int slot = 0; slot < kWidth; ++slot) {
    const bool meets = node.lower[0][slot] <= box.upper[0] && box.lower[0] <= node.upper[0][slot] &&
                       node.lower[1][slot] <= box.upper[1] && box.lower[1] <= node.upper[1][slot] &&
                       node.lower[2][slot] <= box.upper[2] && box.lower[2] <= node.upper[2][slot];
    mask |= static_cast<unsigned>(meets) << slot;
  }
  return mask;
}

int collect(const WideNode* nodes, const FloatBox& box, int* found, int capacity) {
  int open[kMaxOpen];
  int open_count = 0;
  int count = 0;
  open[open_count++] = 0;
  while (open_count > 0) {
    const WideNode& node = nodes[open[--open_count]];
    for (unsigned mask = meeting_slots(node, box); mask != 0; mask &= mask - 1) {
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

const Kernels& baseline_kernels() {
  static constexpr Kernels kernels = {collect, meeting_triangles};
  return kernels;
}

}  // namespace rubicon::collision
