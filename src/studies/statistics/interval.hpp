#pragma once

namespace rubicon::statistics {

/// From `low` to `high`; either may be infinite: not known.
struct Interval {
  double low = 0;
  double high = 0;

  double width() const { return high - low; }
  bool holds(double value) const { return low <= value && value <= high; }
};

}  // namespace rubicon::statistics
