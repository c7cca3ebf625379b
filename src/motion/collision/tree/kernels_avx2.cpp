// Compiled with -mavx2: nothing but plain data and intrinsics may come in here (see wide_node.hpp).
#include "src/motion/collision/tree/kernels.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

#include "src/motion/collision/tree/tree_walk.hpp"
#include "src/motion/collision/tree/triangle_kernel.hpp"

namespace rubicon::collision {
namespace {

/// Which slots of a node meet a box.
struct SlotsMeeting {
  explicit SlotsMeeting(const FloatBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = _mm256_set1_ps(box.lower[axis]);
      upper[axis] = _mm256_set1_ps(box.upper[axis]);
    }
  }

  __m256 lanes(const WideNode& node) const {
    __m256 meets = along(node, 0);
    meets = _mm256_and_ps(meets, along(node, 1));
    return _mm256_and_ps(meets, along(node, 2));
  }

  unsigned operator()(const WideNode& node) const {
    return static_cast<unsigned>(_mm256_movemask_ps(lanes(node)));
  }

  __m256 along(const WideNode& node, int axis) const {
    return _mm256_and_ps(_mm256_cmp_ps(_mm256_load_ps(node.lower[axis]), upper[axis], _CMP_LE_OQ),
                         _mm256_cmp_ps(lower[axis], _mm256_load_ps(node.upper[axis]), _CMP_LE_OQ));
  }

  __m256 lower[3];
  __m256 upper[3];
};

struct SlotsBetween {
  explicit SlotsBetween(const FloatSlabs& slabs) : parallel(slabs.box), count(slabs.count) {
    for (int j = 0; j < count; ++j) {
      for (int axis = 0; axis < 3; ++axis) {
        a[j][axis] = _mm256_set1_ps(slabs.axis[j][axis]);
        reach[j][axis] = _mm256_set1_ps(__builtin_fabsf(slabs.axis[j][axis]));
      }
      middle[j] = _mm256_set1_ps(slabs.middle[j]);
      half[j] = _mm256_set1_ps(slabs.half[j]);
    }
  }

  unsigned operator()(const WideNode& node) const {
    __m256 meets = parallel.lanes(node);
    if (_mm256_movemask_ps(meets) == 0) return 0;
    const __m256 one_half = _mm256_set1_ps(0.5F);
    const __m256 no_sign = _mm256_castsi256_ps(_mm256_set1_epi32(0x7fffffff));
    __m256 centre[3];
    __m256 extent[3];
    for (int axis = 0; axis < 3; ++axis) {
      const __m256 low = _mm256_load_ps(node.lower[axis]);
      const __m256 high = _mm256_load_ps(node.upper[axis]);
      centre[axis] = _mm256_mul_ps(one_half, _mm256_add_ps(low, high));
      extent[axis] = _mm256_mul_ps(one_half, _mm256_sub_ps(high, low));
    }
    for (int j = 0; j < count; ++j) {
      const __m256 distance = _mm256_and_ps(_mm256_sub_ps(dot(a[j], centre), middle[j]), no_sign);
      const __m256 allowed = _mm256_add_ps(dot(reach[j], extent), half[j]);
      meets = _mm256_and_ps(meets, _mm256_cmp_ps(distance, allowed, _CMP_LE_OQ));
    }
    return static_cast<unsigned>(_mm256_movemask_ps(meets));
  }

  static __m256 dot(const __m256 (&u)[3], const __m256 (&v)[3]) {
    return _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(u[0], v[0]), _mm256_mul_ps(u[1], v[1])),
                         _mm256_mul_ps(u[2], v[2]));
  }

  SlotsMeeting parallel;
  int count;
  __m256 a[FloatSlabs::kMost][3];
  __m256 reach[FloatSlabs::kMost][3];
  __m256 middle[FloatSlabs::kMost];
  __m256 half[FloatSlabs::kMost];
};

int collect(const WideNode* nodes, const FloatBox& box, int* found, int capacity) {
  return walk(nodes, SlotsMeeting(box), found, capacity);
}

int collect_between(const WideNode* nodes, const FloatSlabs& slabs, int* found, int capacity) {
  return walk(nodes, SlotsBetween(slabs), found, capacity);
}

}  // namespace

const Kernels* avx2_kernels() {
  static constexpr Kernels kernels = {collect, collect_between, meeting_triangles, met_by_triangle};
  return &kernels;
}

}  // namespace rubicon::collision

#else

namespace rubicon::collision {

const Kernels* avx2_kernels() { return nullptr; }

}  // namespace rubicon::collision

#endif
