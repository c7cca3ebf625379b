#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/simulation/schedule/civil_time.hpp"

namespace rubicon::gantt {

using schedule::Ticks;

/// A moment on the axis with its label.
struct AxisMark {
  Ticks time = 0;
  std::string label;
};

struct TimeAxis {
  std::vector<AxisMark> marks;  ///< one every step, in order
  std::vector<AxisMark> heads;  ///< days or months above them, where each begins; the first at 0
};

/// Marks for [0, end], at most `most` (at least 2) of them, at round times: of the clock and the
/// calendar if `start` is given, else counted from the begin.
TimeAxis make_axis(const std::optional<schedule::CivilTime>& start, Ticks end, int most);

}  // namespace rubicon::gantt
