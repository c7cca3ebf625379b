#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "src/studies/statistics/interval.hpp"

namespace rubicon::statistics {

/// What some numbers are on average and how they spread.
struct Mean {
  std::size_t count = 0;
  double mean = 0;
  double deviation = 0;  ///< standard deviation of one of them, by n - 1; 0 of fewer than two
  /// 95 % interval of the mean (Student); nothing of fewer than two numbers.
  std::optional<Interval> interval;
};

/// Of finite numbers.
Mean mean_of(std::span<const double> values);

/// 97.5 % point of Student's distribution; degrees > 0. To 1e-4 (Abramowitz and Stegun, 26.7.5;
/// below 10 degrees by table).
double student_975(std::size_t degrees);

}  // namespace rubicon::statistics
