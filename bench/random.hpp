#pragma once

#include <cstdint>
#include <random>

namespace rubicon::bench {

/// Numbers from a seed, the same on every machine (the distributions of the standard library are
/// not).
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) * 0x1p-32;
  }
  /// 0 .. count - 1.
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }

 private:
  std::mt19937 engine_;
};

}  // namespace rubicon::bench
