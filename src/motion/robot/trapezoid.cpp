#include "src/motion/robot/trapezoid.hpp"

#include <cmath>

namespace rubicon::robot {

double time_under_way(double distance, double speed, double acceleration) {
  const double gaining = speed / acceleration;  // s until the highest speed
  if (distance < speed * gaining / 2) return std::sqrt(2 * distance / acceleration);
  return distance / speed + gaining / 2;
}

double time_to_rest(double distance, double speed, double acceleration) {
  const double gaining = speed / acceleration;
  if (distance < speed * gaining) return 2 * std::sqrt(distance / acceleration);
  return distance / speed + gaining;
}

}  // namespace rubicon::robot
