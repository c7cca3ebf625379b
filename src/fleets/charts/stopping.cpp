#include "src/fleets/charts/stopping.hpp"

#include <cmath>

namespace rubicon::charts {

SensingNeed sensing_need(const Stopping& stopping, double speed) {
  SensingNeed need;
  need.speed = speed;
  need.until_brakes = speed * (stopping.scan + stopping.reaction);
  need.braked = speed * speed / (2 * stopping.braking);
  need.to_stop = need.until_brakes + need.braked + stopping.standoff;
  need.two_scans = need.to_stop + speed * stopping.scan;
  need.oncoming = 2 * (need.until_brakes + need.braked) + stopping.standoff;
  return need;
}

double greatest_speed(const Stopping& stopping, double range) {
  const double room = range - stopping.standoff;
  if (room <= 0) return 0;
  const double delay = stopping.scan + stopping.reaction;
  // The root of v delay + v^2 / (2 braking) = room, written so that nothing cancels.
  const double root = std::sqrt(delay * delay + 2 * room / stopping.braking);
  return 2 * room / (delay + root);
}

}  // namespace rubicon::charts
