#include "interpreter/machine/motion_run.hpp"

#include <algorithm>

#include "src/motion/robot/trapezoid.hpp"

namespace rubicon::interpreter {

Ticks MotionRun::advance(double distance) {
  if (!accelerates()) return ticks_from_seconds(distance / speed_);
  const double added = distance + lost_;
  const double sum = distance_ + added;
  lost_ = added - (sum - distance_);
  distance_ = sum;
  const Ticks before = time_;
  time_ =
      std::max(before, ticks_from_seconds(robot::time_under_way(distance_, speed_, acceleration_)));
  return time_ - before;
}

Ticks MotionRun::rest() const {
  if (!accelerates()) return 0;
  const Ticks whole = ticks_from_seconds(robot::time_to_rest(distance_, speed_, acceleration_));
  return std::max<Ticks>(whole - time_, 0);
}

}  // namespace rubicon::interpreter
