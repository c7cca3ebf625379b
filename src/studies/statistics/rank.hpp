#pragma once

#include <span>
#include <vector>

namespace rubicon::statistics {

/// The rank of each number, from 1; equal ones share the mean of theirs.
std::vector<double> ranks_of(std::span<const double> values);

/// Spearman's rank correlation of pairs, -1 to 1; 0 where one side does not vary.
double rank_correlation(std::span<const double> a, std::span<const double> b);

}  // namespace rubicon::statistics
