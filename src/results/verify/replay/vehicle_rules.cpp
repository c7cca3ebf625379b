#include "src/results/verify/replay/vehicle_rules.hpp"

#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"
#include "src/results/verify/replay/step_rules.hpp"

namespace rubicon::verify {

namespace {

/// What a step of a metre changes at a heading, with a turn in it; all others stand at 0.
std::vector<double> driven_metre(const SceneRobot& robot, std::size_t drive, std::size_t heading,
                                 double heading_deg, double turn_deg = 0) {
  std::vector<double> q(robot.parameters.size(), 0.0);
  std::vector<double> steps(q.size(), 0.0);
  q[heading] = heading_deg;
  steps[drive] = 1;
  steps[heading] = turn_deg;
  return change_by(robot, q, steps, robot.parameters[drive].body);
}

/// Whether a step that turns by some angle leads along the chord of an arc of that angle.
bool drives_along_chords(const SceneRobot& robot, const VehicleRules& vehicle) {
  constexpr double kTurn = 10;
  const std::vector<double> arc = driven_metre(robot, vehicle.drive, vehicle.heading, 0, kTurn);
  const double mean = vehicle.drift_deg + kTurn / 2;
  return std::fabs(arc[vehicle.x] - math::cos_deg(mean)) <= kValueSlack &&
         std::fabs(arc[vehicle.y] - math::sin_deg(mean)) <= kValueSlack;
}

}  // namespace

std::vector<double> change_by(const SceneRobot& robot, std::span<const double> q,
                              std::span<const double> steps, int body) {
  std::vector<double> change(q.size(), 0.0);
  for (std::size_t i = 0; i < q.size(); ++i) {
    const SceneParameter& p = robot.parameters[i];
    if (p.derived || p.body != body) continue;
    change[i] = p.rule.value({q, steps, robot.starts}) - q[i];
  }
  return change;
}

std::optional<VehicleRules> find_vehicle(const SceneRobot& robot) {
  const std::size_t n = robot.parameters.size();
  for (std::size_t drive = 0; drive < n; ++drive) {
    for (std::size_t turn = 0; turn < n; ++turn) {
      const SceneParameter& angle = robot.parameters[turn];
      if (turn == drive || angle.derived || !(angle.step > 0)) continue;
      if (angle.body != robot.parameters[drive].body || !(robot.parameters[drive].step > 0)) {
        continue;
      }
      const std::vector<double> ahead = driven_metre(robot, drive, turn, 0);
      const std::vector<double> across = driven_metre(robot, drive, turn, 90);
      std::vector<std::size_t> changed;
      for (std::size_t i = 0; i < n; ++i) {
        if (std::fabs(ahead[i]) > kValueSlack || std::fabs(across[i]) > kValueSlack) {
          changed.push_back(i);
        }
      }
      if (changed.size() != 2) continue;
      const std::size_t x = changed[0];
      const std::size_t y = changed[1];
      if (std::fabs(across[x] + ahead[y]) > kValueSlack ||
          std::fabs(across[y] - ahead[x]) > kValueSlack) {
        continue;
      }
      VehicleRules vehicle{drive, turn, x, y, math::atan2_deg(ahead[y], ahead[x])};
      vehicle.turns_driving = drives_along_chords(robot, vehicle);
      return vehicle;
    }
  }
  return std::nullopt;
}

double short_way(const SceneParameter& parameter, double from, double to) {
  if (!parameter.cyclic) return to - from;
  const double way = math::normalised_deg(to - from);
  return way == math::kHalfTurn_deg && parameter.prefers_less ? -way : way;
}

}  // namespace rubicon::verify
