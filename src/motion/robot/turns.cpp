#include "src/motion/robot/turns.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/turns.hpp"

namespace rubicon::robot {
namespace {

using math::kHalfTurn_deg;
using math::kTurn_deg;

/// How near to a quarter turn counts as exactly a quarter turn, in degrees: rounding of bearings,
/// far below any step.
constexpr double kQuarterTurnTolerance = 1e-9;

}  // namespace

double reduced(const Parameter& parameter, double value) {
  return parameter.cyclic ? math::normalised_deg(value) : value;
}

void normalise(const RobotModel& model, std::span<double> q) {
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = reduced(model.parameters[i], q[i]);
}

double way_between(const Parameter& parameter, double from, double to) {
  const double way = reduced(parameter, to - from);
  return parameter.cyclic && way == kHalfTurn_deg && parameter.prefer < 0 ? -way : way;
}

double nearest_turn_equivalent(const Parameter& parameter, double value, double current) {
  if (!parameter.rotation || !parameter.limited() || parameter.counts_turns ||
      !std::isfinite(value)) {
    return value;
  }
  // A value that misses a limit by rounding stands on it: 1e-9 degrees are far below every step.
  constexpr double kRounding_deg = 1e-9;
  const double fewest = std::ceil((parameter.lower - kRounding_deg - value) / kTurn_deg);
  const double most = std::floor((parameter.upper + kRounding_deg - value) / kTurn_deg);
  if (!(fewest <= most)) return value;
  const double turns = (current - value) / kTurn_deg;
  // Half a turn away both ways is a tie of directions.
  const double nearest = parameter.prefer < 0 ? std::ceil(turns - 0.5) : std::floor(turns + 0.5);
  const double equivalent = value + kTurn_deg * std::clamp(nearest, fewest, most);
  return std::clamp(equivalent, parameter.lower, parameter.upper);
}

bool has_turn_equivalent(const Parameter& parameter, double value) {
  if (parameter.counts_turns) return value >= parameter.lower && value <= parameter.upper;
  return std::floor((parameter.upper - value) / kTurn_deg) >=
         std::ceil((parameter.lower - value) / kTurn_deg);
}

double nearest_axis(const Parameter& parameter, double value, double current) {
  constexpr double kQuarterTurn_deg = kTurn_deg / 4;
  double off = math::normalised_axis_deg(value - current);
  if (std::fabs(std::fabs(off) - kQuarterTurn_deg) <= kQuarterTurnTolerance) {
    off = kQuarterTurn_deg * parameter.prefer;
  }
  return current + off;
}

}  // namespace rubicon::robot
