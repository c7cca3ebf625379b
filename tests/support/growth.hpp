#pragma once

#include <algorithm>
#include <ctime>
#include <limits>

namespace rubicon::test {

/// Seconds of processor time of this thread that `work` takes. Unlike the time on the wall it does
/// not grow when other programs run beside it, only a little when they share caches.
template <typename Work>
double processor_seconds(const Work& work) {
  const auto now = [] {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double begin = now();
  work();
  return now() - begin;
}

/// Whether `large` takes less than `factor` times what `small` takes, plus 20 ms. Both are measured
/// again, the best of each kept, until it does or ten rounds are over: noise passes, a square
/// stays. Make `large` some 16 times `small` and `factor` 64, halfway from a line to a square on a
/// logarithmic scale: on a busy machine what no longer fits the caches can take three times as
/// long.
template <typename Small, typename Large>
bool grows_at_most(double factor, const Small& small, const Large& large) {
  double best_small = std::numeric_limits<double>::infinity();
  double best_large = best_small;
  for (int round = 0; round < 10; ++round) {
    best_small = std::min(best_small, processor_seconds(small));
    best_large = std::min(best_large, processor_seconds(large));
    if (best_large < factor * best_small + 0.02) return true;
  }
  return false;
}

}  // namespace rubicon::test
