#include "src/motion/collision/tree/kernels.hpp"
#include "src/motion/collision/tree/tree_walk.hpp"
#include "src/motion/collision/tree/triangle_kernel.hpp"

namespace rubicon::collision {
namespace {

/// Which slots of a node meet a box.
struct SlotsMeeting {
  explicit SlotsMeeting(const FloatBox& asked) : box(asked) {}

  unsigned operator()(const WideNode& node) const {
    unsigned mask = 0;
    for (int slot = 0; slot < kWidth; ++slot) {
      const bool meets =
          node.lower[0][slot] <= box.upper[0] && box.lower[0] <= node.upper[0][slot] &&
          node.lower[1][slot] <= box.upper[1] && box.lower[1] <= node.upper[1][slot] &&
          node.lower[2][slot] <= box.upper[2] && box.lower[2] <= node.upper[2][slot];
      mask |= static_cast<unsigned>(meets) << slot;
    }
    return mask;
  }

  const FloatBox& box;
};

struct SlotsBetween {
  explicit SlotsBetween(const FloatSlabs& asked) : parallel(asked.box), slabs(asked) {}

  unsigned operator()(const WideNode& node) const {
    unsigned mask = parallel(node);
    for (int slot = 0; slot < kWidth; ++slot) {
      if ((mask >> slot & 1U) == 0) continue;
      float centre[3];
      float half[3];
      for (int axis = 0; axis < 3; ++axis) {
        centre[axis] = 0.5F * (node.lower[axis][slot] + node.upper[axis][slot]);
        half[axis] = 0.5F * (node.upper[axis][slot] - node.lower[axis][slot]);
      }
      for (int j = 0; j < slabs.count; ++j) {
        const float* a = slabs.axis[j];
        const float at = (a[0] * centre[0] + a[1] * centre[1]) + a[2] * centre[2];
        const float reach = (__builtin_fabsf(a[0]) * half[0] + __builtin_fabsf(a[1]) * half[1]) +
                            __builtin_fabsf(a[2]) * half[2];
        if (!(__builtin_fabsf(at - slabs.middle[j]) <= reach + slabs.half[j]))
          mask &= ~(1U << slot);
      }
    }
    return mask;
  }

  SlotsMeeting parallel;
  const FloatSlabs& slabs;
};

int collect(const WideNode* nodes, const FloatBox& box, int* found, int capacity) {
  return walk(nodes, SlotsMeeting(box), found, capacity);
}

int collect_between(const WideNode* nodes, const FloatSlabs& slabs, int* found, int capacity) {
  return walk(nodes, SlotsBetween(slabs), found, capacity);
}

}  // namespace

const Kernels& baseline_kernels() {
  static constexpr Kernels kernels = {collect, collect_between, meeting_triangles, met_by_triangle};
  return kernels;
}

}  // namespace rubicon::collision
