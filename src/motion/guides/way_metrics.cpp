#include "src/motion/guides/way_metrics.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::guides {

namespace {

using math::at;

/// Degrees or metres by which a parameter is moved to see how it moves the tool.
constexpr double kNudge = 1e-4;

/// How far the tool goes for a metre or radian of a parameter, all others left alone: the effective
/// arm of eq. 3.10 (appendix A gives it for an excavator).
double effective_arm(const robot::RobotModel& model, const robot::Mounting& mounting,
                     std::span<const double> q, int parameter) {
  std::vector<double> nudged(q.begin(), q.end());
  nudged[at(parameter)] += kNudge;
  const math::Vec3 ahead = robot::tool_pose(model, mounting, nudged).translation();
  nudged[at(parameter)] -= 2 * kNudge;
  const math::Vec3 behind = robot::tool_pose(model, mounting, nudged).translation();
  const bool rotation = model.parameters[at(parameter)].rotation;
  return (ahead - behind).norm() / (2 * (rotation ? math::radians(kNudge) : kNudge));
}

double piece_time(const robot::RobotModel& model, const Leg& leg, std::span<const double> q,
                  std::span<const double> next, bool loaded) {
  double time = 0;
  if (leg.is_there(q, next)) return time;
  const auto speed_of = [&](int i) {
    const robot::Parameter& p = model.parameters[at(i)];
    return loaded ? p.loaded_speed : p.speed;
  };
  const auto place = leg.place();
  const bool vehicle = leg.drive() >= 0;
  if (vehicle && speed_of(leg.drive()) > 0) {
    const double dx = next[at(place[0])] - q[at(place[0])];
    const double dy = next[at(place[1])] - q[at(place[1])];
    time = std::sqrt(dx * dx + dy * dy) / speed_of(leg.drive());
  }
  for (const int i : leg.parameters()) {
    const double speed = speed_of(i);
    const bool driven = vehicle && (i == place[0] || i == place[1]);
    if (!(speed > 0) || driven) continue;
    time = std::max(time, std::fabs(next[at(i)] - q[at(i)]) / speed);
  }
  return time;
}

}  // namespace

double leg_time(const robot::RobotModel& model, const Leg& leg, std::span<const double> q,
                std::span<const double> next, bool loaded) {
  double time = 0;
  std::vector<double> now(q.begin(), q.end());
  for (std::vector<double>& corner : leg.corners(q, next)) {
    time += piece_time(model, leg, now, corner, loaded);
    now = std::move(corner);
  }
  return time;
}

WayMetrics way_metrics(const robot::RobotModel& model, const robot::Mounting& mounting,
                       const std::vector<std::vector<double>>& way, bool loaded,
                       double turn_radius) {
  WayMetrics metrics;
  const Leg leg(model, mounting, {}, turn_radius);
  std::vector<double> before;  // unit direction of the leg before
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    metrics.motion_time += leg_time(model, leg, way[k], way[k + 1], loaded);
    std::vector<double> direction;
    double square = 0;
    for (std::size_t i = 0; i < model.parameters.size(); ++i) {
      const robot::Parameter& p = model.parameters[i];
      const double off = robot::way_between(p, way[k][i], way[k + 1][i]);
      const double arm = off == 0 ? 0 : effective_arm(model, mounting, way[k], static_cast<int>(i));
      metrics.length += arm * std::fabs(p.rotation ? math::radians(off) : off);
    }
    for (const int i : leg.parameters()) {
      direction.push_back(
          robot::way_between(model.parameters[at(i)], way[k][at(i)], way[k + 1][at(i)]));
      square += direction.back() * direction.back();
    }
    if (!(square > 0)) continue;
    for (double& each : direction) each /= std::sqrt(square);
    for (std::size_t i = 0; i < before.size(); ++i) {
      metrics.roughness += std::fabs(direction[i] - before[i]);
    }
    before = std::move(direction);
  }
  return metrics;
}

}  // namespace rubicon::guides
