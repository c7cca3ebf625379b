// Compiled with -mavx2: nothing but plain data and intrinsics may come in here (see wide_node.hpp).
#include "src/collision/kernels.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

#include "src/collision/triangle_kernel.hpp"

namespace rubicon::collision {
namespace {

int collect(const WideNode* nodes, const FloatBox& box, int* found, int capacity) {
  __m256 lower[3];
  __m256 upper[3];
  for (int axis = 0; axis < 3; ++axis) {
    lower[axis] = _mm256_set1_ps(box.lower[axis]);
    upper[axis] = _mm256_set1_ps(box.upper[axis]);
  }
  int open[kMaxOpen];
  int open_count = 0;
  int count = 0;
  open[open_count++] = 0;
  while (open_count > 0) {
    const WideNode& node = nodes[open[--open_count]];
    __m256 meets = _mm256_cmp_ps(_mm256_load_ps(node.lower[0]), upper[0], _CMP_LE_OQ);
    meets =
        _mm256_and_ps(meets, _mm256_cmp_ps(lower[0], _mm256_load_ps(node.upper[0]), _CMP_LE_OQ));
    for (int axis = 1; axis < 3; ++axis) {
      meets = _mm256_and_ps(
          meets, _mm256_cmp_ps(_mm256_load_ps(node.lower[axis]), upper[axis], _CMP_LE_OQ));
      meets = _mm256_and_ps(
          meets, _mm256_cmp_ps(lower[axis], _mm256_load_ps(node.upper[axis]), _CMP_LE_OQ));
    }
    for (unsigned mask = static_cast<unsigned>(_mm256_movemask_ps(meets)); mask != 0;
         mask &= mask - 1) {
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

const Kernels* avx2_kernels() {
  static constexpr Kernels kernels = {collect, meeting_triangles};
  return &kernels;
}

}  // namespace rubicon::collision

#else

namespace rubicon::collision {

const Kernels* avx2_kernels() { return nullptr; }

}  // namespace rubicon::collision

#endif
