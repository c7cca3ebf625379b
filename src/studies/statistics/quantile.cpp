#include "src/studies/statistics/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rubicon::statistics {

namespace {

constexpr double kLevel = 0.95;

/// P(B = k) for k = 0 ... count: from the likeliest outwards, then made to add up to 1, so that
/// nothing but the four operations is needed and nothing overflows.
std::vector<double> binomial(std::size_t count, double p) {
  std::vector<double> weight(count + 1, 0.0);
  const double n = static_cast<double>(count);
  const auto mode = std::min(count, static_cast<std::size_t>((n + 1) * p));
  weight[mode] = 1;
  for (std::size_t k = mode; k < count; ++k) {
    weight[k + 1] =
        weight[k] * (n - static_cast<double>(k)) / static_cast<double>(k + 1) * (p / (1 - p));
  }
  for (std::size_t k = mode; k > 0; --k) {
    weight[k - 1] =
        weight[k] * static_cast<double>(k) / (n - static_cast<double>(k) + 1) * ((1 - p) / p);
  }
  double sum = 0;
  for (const double each : weight) sum += each;
  for (double& each : weight) each /= sum;
  return weight;
}

}  // namespace

QuantileRanks quantile_ranks(std::size_t count, double p) {
  QuantileRanks result;
  if (count == 0 || !(p > 0 && p < 1)) return result;
  const std::vector<double> share = binomial(count, p);
  // The quantile is at or above the number of rank l as long as fewer than l are not above it.
  const double tail = (1 - kLevel) / 2;
  std::size_t low = 0;  // 0: minus infinity
  double below = 0;     // P(B < low)
  while (low < count && below + share[low] <= tail) below += share[low++];
  std::size_t high = count + 1;  // count + 1: infinity
  double above = 0;              // P(B >= high)
  while (high > low + 1 && above + share[high - 1] <= tail) above += share[--high];
  // One rank more can often be spared on one side.
  if (high > low + 2 && above + share[high - 1] + below <= 1 - kLevel) {
    --high;
  } else if (high > low + 2 && below + share[low] + above <= 1 - kLevel) {
    ++low;
  }
  if (low >= 1) result.low = low;
  if (high <= count) result.high = high;
  return result;
}

std::size_t quantile_rank(std::size_t count, double p) {
  const double n = static_cast<double>(count);
  // A share such as 0.8 of 10 numbers is 8 of them, not 8.0000000000000002.
  return static_cast<std::size_t>(std::clamp(std::ceil(n * p - 1e-9), 1.0, n));
}

double quantile(std::span<const double> sorted, double p) {
  return sorted[quantile_rank(sorted.size(), p) - 1];
}

Interval quantile_interval(std::span<const double> sorted, double p) {
  const QuantileRanks ranks = quantile_ranks(sorted.size(), p);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {ranks.low ? sorted[*ranks.low - 1] : -kInfinity,
          ranks.high ? sorted[*ranks.high - 1] : kInfinity};
}

}  // namespace rubicon::statistics
