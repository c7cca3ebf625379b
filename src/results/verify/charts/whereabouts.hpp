#pragma once

#include <cstddef>
#include <vector>

#include "src/results/verify/charts/charts_result.hpp"

namespace rubicon::verify {

/// Where a robot is at a moment, by the chart that held until then.
struct Whereabouts {
  enum class Kind { not_started, at_node, at_present_place, in_motion };
  Kind kind = Kind::not_started;
  int node = -1;  ///< at_node
  /// The stop to which it drives, or that comes next; the number of all where none does.
  std::size_t next = 0;
  Ticks remaining = 0;  ///< in_motion: of the driving time to it
};

Whereabouts whereabouts(const std::vector<ChartStop>& stops, Ticks now);

}  // namespace rubicon::verify
