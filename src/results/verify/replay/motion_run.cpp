#include "src/results/verify/replay/motion_run.hpp"

#include <algorithm>
#include <cmath>

#include "src/results/verify/input/fault.hpp"

namespace rubicon::verify {

namespace {

double speed_of(const SceneParameter& p, bool loaded) { return loaded ? p.loaded_speed : p.speed; }

/// s from rest to a distance: at a speed of sqrt(2 a d) while it rises, then at the highest.
double seconds_to(double distance, double speed, double acceleration) {
  const double reached = std::sqrt(2 * acceleration * std::max(distance, 0.0));
  if (reached < speed) return reached / acceleration;
  const double ramp = speed * speed / (2 * acceleration);
  return speed / acceleration + (distance - ramp) / speed;
}

/// s from rest to rest over a distance: up to the highest speed that half of it allows, and down.
double seconds_between_rests(double distance, double speed, double acceleration) {
  const double peak = std::min(speed, std::sqrt(acceleration * std::max(distance, 0.0)));
  const double ramps = peak * peak / acceleration;
  return 2 * peak / acceleration + std::max(distance - ramps, 0.0) / peak;
}

double ticks(double seconds) { return seconds * static_cast<double>(kSecond); }

Ticks rounded(double ticks) { return static_cast<Ticks>(std::floor(ticks + 0.5)); }

}  // namespace

bool MotionRun::is_of_same_parts(const MotionRun& other) const {
  return std::equal(parts.begin(), parts.end(), other.parts.begin(), other.parts.end(),
                    [](const RunPart& a, const RunPart& b) {
                      return a.parameter == b.parameter && (a.gone > 0) == (b.gone > 0);
                    });
}

RunTime step_time(const SceneParameter& parameter, bool loaded, double gone, int steps,
                  double step) {
  const double speed = speed_of(parameter, loaded);
  const double length = std::fabs(step);
  if (!(speed > 0)) return {};
  if (!(parameter.acceleration > 0)) return {rounded(ticks(length / speed)), kTimeSlack};
  const auto at = [&](double distance) {
    return ticks(seconds_to(distance, speed, parameter.acceleration));
  };
  const double from = std::fabs(gone);
  const double off = kDistanceSlack * (steps + 1);
  const double later = at(from + length + off) - at(from + length);
  const double earlier = from > 0 ? at(from + off) - at(from) : 0;
  return {rounded(at(from + length)) - rounded(at(from)),
          kTimeSlack + static_cast<Ticks>(later + earlier)};
}

RunTime rest_time(const SceneRobot& robot, const MotionRun& run) {
  RunTime longest{0, kTimeSlack};
  for (const RunPart& part : run.parts) {
    const SceneParameter& p = robot.parameters[static_cast<std::size_t>(part.parameter)];
    const double speed = speed_of(p, run.loaded);
    if (!(p.acceleration > 0) || !(speed > 0)) continue;
    const auto at = [&](double distance) {
      return ticks(seconds_between_rests(distance, speed, p.acceleration) -
                   seconds_to(distance, speed, p.acceleration));
    };
    const double gone = std::fabs(part.gone);
    const double off = kDistanceSlack * (run.steps + 1);
    const Ticks time = rounded(at(gone));
    const auto slack = static_cast<Ticks>(std::fabs(at(gone + off) - at(gone)));
    if (time > longest.time) longest = {time, kTimeSlack + slack};
  }
  return longest;
}

}  // namespace rubicon::verify
