#include "src/results/verify/replay/way_figures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"
#include "src/results/verify/input/mechanism.hpp"
#include "src/results/verify/replay/step_rules.hpp"
#include "src/results/verify/replay/vehicle_rules.hpp"

namespace rubicon::verify {

namespace {

/// Part of its step by which a parameter is at a value.
constexpr double kThere = 1e-6;

/// Share of a figure that it may differ by. Reason: arms are found by differences of poses, here
/// and there with other distances. Consequence: what is off by less than a millionth is not seen.
constexpr double kFigureShare = 1e-6;

/// Radians or metres by which a parameter is moved to either side to see its arm.
constexpr double kArmShift = 2e-5;

/// m by which an arm may be off for each metre that the tool is away from the origin: the last
/// digits of two poses, over a distance of 1e-6 rad or more between them.
constexpr double kArmRounding = 1e-9;

class WayReckoning {
 public:
  WayReckoning(const SceneRobot& robot, bool loaded, double turn_radius)
      : robot_(robot),
        mechanism_(robot),
        vehicle_(find_vehicle(robot)),
        loaded_(loaded),
        steers_(turn_radius > 0 && vehicle_.has_value()) {}

  WayFigures figures(const std::vector<std::vector<double>>& way) {
    for (std::size_t k = 1; k < way.size(); ++k) {
      add_length(way[k - 1], way[k]);
      add_turn(way[k - 1], way[k]);
      add_time(way[k - 1], way[k]);
    }
    for (WayFigure* each : {&result_.roughness, &result_.length, &result_.motion_time}) {
      each->slack += kFigureShare * each->value + kValueSlack;
    }
    return result_;
  }

 private:
  using Values = std::vector<double>;

  double way_of(std::size_t i, const Values& from, const Values& to) const {
    return short_way(robot_.parameters[i], from[i], to[i]);
  }

  /// Each parameter alone, where the leg begins: its way times the tool's way for so little of it.
  void add_length(const Values& from, const Values& to) {
    for (std::size_t i = 0; i < robot_.parameters.size(); ++i) {
      const double way = way_of(i, from, to);
      if (way == 0) continue;
      const bool turns = robot_.parameters[i].rotation;
      const double amount = std::fabs(turns ? math::radians(way) : way);
      Values there = from;
      const double shift = turns ? math::degrees(kArmShift) : kArmShift;
      there[i] = from[i] + shift;
      const Vec3 p_ahead = mechanism_.pose(mechanism_.tool(), there).translation();
      there[i] = from[i] - shift;
      const Vec3 p_behind = mechanism_.pose(mechanism_.tool(), there).translation();
      result_.length.value += amount * (p_ahead - p_behind).norm() / (2 * kArmShift);
      result_.length.slack += amount * kArmRounding * (1 + p_ahead.norm());
    }
  }

  /// The unit vectors of two legs in a row, in degrees and metres: what their parts differ by.
  void add_turn(const Values& from, const Values& to) {
    Values direction;
    double square = 0;
    for (std::size_t i = 0; i < robot_.parameters.size(); ++i) {
      if (robot_.parameters[i].derived) continue;
      direction.push_back(way_of(i, from, to));
      square += direction.back() * direction.back();
    }
    if (!(square > 0)) return;
    const double size = std::sqrt(square);
    for (double& each : direction) each /= size;
    for (std::size_t i = 0; i < direction_.size(); ++i) {
      result_.roughness.value += std::fabs(direction[i] - direction_[i]);
    }
    direction_ = std::move(direction);
  }

  double speed(std::size_t i) const {
    const SceneParameter& p = robot_.parameters[i];
    return loaded_ ? p.loaded_speed : p.speed;
  }

  double time_of(std::size_t i, double amount) const {
    return speed(i) > 0 ? std::fabs(amount) / speed(i) : 0;
  }

  void take(double seconds) { result_.motion_time.value += seconds; }

  void add_time(const Values& from, const Values& to) {
    // Values are what they should be to the slack, whatever takes longest.
    for (std::size_t i = 0; i < robot_.parameters.size(); ++i) {
      if (!robot_.parameters[i].derived && way_of(i, from, to) != 0) {
        result_.motion_time.slack += time_of(i, kValueSlack);
      }
    }
    double turned = 0;  // of the heading, before the others run
    if (vehicle_) {
      const double dx = to[vehicle_->x] - from[vehicle_->x];
      const double dy = to[vehicle_->y] - from[vehicle_->y];
      const double distance = std::sqrt(dx * dx + dy * dy);
      if (distance > kThere * robot_.parameters[vehicle_->drive].step) {
        turned = steers_ ? drive_chord(from, to, distance) : face_and_drive(from, dx, dy, distance);
      }
    }
    add_others(from, to, turned);
  }

  /// On an arc, forwards or backwards: turning while it drives, or half before and half after.
  double drive_chord(const Values& from, const Values& to, double distance) {
    const double turn = way_of(vehicle_->heading, from, to);
    const double turning = time_of(vehicle_->heading, turn);
    const double driving = time_of(vehicle_->drive, distance);
    take(vehicle_->turns_driving ? std::max(turning, driving) : turning + driving);
    return turn;
  }

  /// It turns to where it goes, on the spot, and drives there.
  double face_and_drive(const Values& from, double dx, double dy, double distance) {
    const double ahead_deg = from[vehicle_->heading] + vehicle_->drift_deg;
    const double along = dx * math::cos_deg(ahead_deg) + dy * math::sin_deg(ahead_deg);
    const double beside = dy * math::cos_deg(ahead_deg) - dx * math::sin_deg(ahead_deg);
    // A vehicle that comes near enough straight ahead need not turn.
    const double near = 0.25 * kThere * robot_.parameters[vehicle_->drive].step;
    const double turn = std::fabs(beside) <= near && along > 0 ? 0 : math::atan2_deg(beside, along);
    take(time_of(vehicle_->heading, turn) + time_of(vehicle_->drive, distance));
    return turn;
  }

  /// The slowest of what is left.
  void add_others(const Values& from, const Values& to, double turned) {
    double slowest = 0;
    for (std::size_t i = 0; i < robot_.parameters.size(); ++i) {
      const SceneParameter& p = robot_.parameters[i];
      if (p.derived || (vehicle_ && (i == vehicle_->x || i == vehicle_->y))) continue;
      const bool heads = vehicle_ && i == vehicle_->heading;
      const double left = short_way(p, heads ? from[i] + turned : from[i], to[i]);
      slowest = std::max(slowest, time_of(i, left));
    }
    take(slowest);
  }

  const SceneRobot& robot_;
  Mechanism mechanism_;
  std::optional<VehicleRules> vehicle_;
  bool loaded_;
  bool steers_;
  Values direction_;  ///< of the leg before, of length 1
  WayFigures result_;
};

}  // namespace

bool WayFigure::fits(double told) const { return std::fabs(told - value) <= slack; }

WayFigures way_figures(const SceneRobot& robot, const std::vector<std::vector<double>>& way,
                       bool loaded, double turn_radius) {
  return WayReckoning(robot, loaded, turn_radius).figures(way);
}

}  // namespace rubicon::verify
