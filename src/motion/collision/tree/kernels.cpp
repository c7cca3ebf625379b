#include "src/motion/collision/tree/kernels.hpp"

#include <atomic>

#include "src/motion/collision/swept_query.hpp"

namespace rubicon::collision {
namespace {

bool processor_has_avx2() {
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

const Kernels* best_kernels() {
  const Kernels* avx2 = processor_has_avx2() ? avx2_kernels() : nullptr;
  return avx2 != nullptr ? avx2 : &baseline_kernels();
}

// What the processor can do is a fact of the process, not of a query.
std::atomic<const Kernels*>& chosen_kernels() {
  static std::atomic<const Kernels*> chosen = best_kernels();
  return chosen;
}

}  // namespace

const Kernels& kernels() { return *chosen_kernels().load(std::memory_order_relaxed); }

Simd simd_in_use() { return &kernels() == &baseline_kernels() ? Simd::kBaseline : Simd::kAvx2; }

void use_simd(Simd level) {
  chosen_kernels() = level == Simd::kBaseline ? &baseline_kernels() : best_kernels();
}

}  // namespace rubicon::collision
