#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "src/studies/statistics/interval.hpp"

namespace rubicon::statistics {

/// Which of n numbers in order, counted from 1, bound the p-quantile with 95 %: so for every
/// distribution, since the count of numbers below a quantile is binomial (David and Nagaraja, Order
/// Statistics, 7.1). Nothing where too few numbers are there to bound it on that side.
struct QuantileRanks {
  std::optional<std::size_t> low;
  std::optional<std::size_t> high;
};
QuantileRanks quantile_ranks(std::size_t count, double p);

/// Which of n numbers in order, counted from 1, is their p-quantile. count > 0, 0 < p <= 1.
std::size_t quantile_rank(std::size_t count, double p);

/// The p-quantile of numbers in ascending order, not empty: the least of them below or at which a
/// share of p or more lies. 0 < p <= 1.
double quantile(std::span<const double> sorted, double p);

/// Its 95 % interval: two of the numbers; infinite where the numbers do not bound it.
Interval quantile_interval(std::span<const double> sorted, double p);

}  // namespace rubicon::statistics
