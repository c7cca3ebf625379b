#pragma once

#include <span>
#include <vector>

#include "interpreter/program/world.hpp"
#include "src/results/replay/machine.hpp"

namespace rubicon::replay {

using interpreter::Ticks;

/// An accepted attempt as a trace tells it: all values before and after (m or degrees), the
/// parameters that its command moved.
struct RecordedStep {
  std::span<const double> before;
  std::span<const double> after;
  std::span<const int> moved;
  bool loaded = false;
  Ticks duration = 0;
  /// How far each parameter has gone in the run that goes on (m or degrees, its sign the
  /// direction); empty: nothing goes on.
  std::span<const double> gone = {};
};

struct ReachedStep {
  std::vector<double> values;  ///< per parameter, turns not reduced
  std::vector<double> steps;   ///< per parameter, 0 where the command did not move it
};

/// The values to which the step led in a straight line: `after` with the whole turns that a record
/// leaves out. The steps of the moved parameters are found from the values by Newton's method (one
/// round for rules that are linear in them). A value that no step leads to is taken as recorded,
/// the shorter way round.
ReachedStep reached_values(const Machine& machine, const RecordedStep& step);

}  // namespace rubicon::replay
