#pragma once

#include <optional>
#include <span>

#include "src/studies/statistics/interval.hpp"

namespace rubicon::statistics {

/// How many times pairs are drawn again.
inline constexpr int kResamples = 1000;

/// 95 % interval of the difference of the p-quantiles of `b` and `a`, whose numbers are pairs: by
/// drawing pairs again, kResamples times, from a fixed seed (percentile bootstrap; Efron and
/// Tibshirani, 1993, ch. 13). Nothing of fewer than 20 pairs, or where a quantile of a draw is
/// infinite.
std::optional<Interval> quantile_difference(std::span<const double> a, std::span<const double> b,
                                            double p);

}  // namespace rubicon::statistics
