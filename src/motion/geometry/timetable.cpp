#include "src/motion/geometry/timetable.hpp"

#include <algorithm>
#include <cassert>
#include <memory>

#include "src/motion/math/angles.hpp"

namespace rubicon::geometry {

namespace {

/// Degrees below which two poses are turned alike: at 1 km from the origin of the frame this is 2
/// um.
constexpr double kNoTurn = 1e-7;

/// The origin goes straight, the axes turn about a fixed direction.
class GoingAndTurning : public GeneralMotion {
 public:
  GoingAndTurning(const Pose& X0, const Vec3& way, const Vec3& axis, double angle_deg)
      : X0_(X0), way_(way), axis_(axis), angle_deg_(angle_deg) {}

  Pose pose(double s) const override {
    Pose X = X0_;
    X.linear() = math::rotation_about_deg(axis_, s * angle_deg_) * X0_.linear();
    X.translation() += s * way_;
    return X;
  }

  /// A point at most r from the origin is drawn to it with r times the square of the turn's speed:
  /// from its chord it is away by no more than an eighth of that over the time squared.
  double chord_deviation(double s0, double s1, double reach) const override {
    const double turn = math::radians((s1 - s0) * angle_deg_);
    return reach * turn * turn / 8;
  }

 private:
  Pose X0_;
  Vec3 way_;
  Vec3 axis_;
  double angle_deg_;
};

/// The turn from one place to the next, about an axis in the world.
struct Turn {
  Vec3 axis = Vec3::UnitZ();
  double angle_deg = 0;
};

Turn turn_between(const Pose& X_first, const Pose& X_second) {
  const math::Mat3 R = X_second.linear() * X_first.linear().transpose();
  Turn turn;
  turn.angle_deg = math::rotation_angle_deg(R);
  if (turn.angle_deg < kNoTurn) return {};
  const Vec3 axis(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  // About an upright axis nothing is to lean by rounding.
  if (axis.x() == 0 && axis.y() == 0) {
    turn.axis = axis.z() < 0 ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitZ());
  } else {
    turn.axis = axis.normalized();
  }
  return turn;
}

/// The pose at a share of the way between two places.
Pose pose_between(const Pose& X_first, const Pose& X_second, const Turn& turn, double s) {
  Pose X = X_first;
  if (turn.angle_deg != 0) {
    X.linear() = math::rotation_about_deg(turn.axis, s * turn.angle_deg) * X_first.linear();
  }
  X.translation() += s * (X_second.translation() - X_first.translation());
  return X;
}

double share_of(const TimedPlace& first, const TimedPlace& second, std::int64_t time) {
  return static_cast<double>(time - first.time) / static_cast<double>(second.time - first.time);
}

Motion motion_of(const TimedPlace& first, const TimedPlace& second, std::int64_t from,
                 std::int64_t to) {
  const Turn turn = turn_between(first.X_WO, second.X_WO);
  const double s0 = share_of(first, second, from);
  const double s1 = share_of(first, second, to);
  const Pose X0 = pose_between(first.X_WO, second.X_WO, turn, s0);
  const Vec3 way = (s1 - s0) * (second.X_WO.translation() - first.X_WO.translation());
  if (turn.angle_deg == 0) return translating(X0, way);
  const double angle_deg = (s1 - s0) * turn.angle_deg;
  if (way.isZero(0)) {
    ScrewMotion screw;
    screw.X0 = X0;
    screw.axis = turn.axis;
    screw.point = X0.translation();
    screw.angle_deg = angle_deg;
    return Motion{screw};
  }
  return Motion{std::make_shared<const GoingAndTurning>(X0, way, turn.axis, angle_deg)};
}

/// The first place that is later than the time.
auto place_after(const Timetable& timetable, std::int64_t time) {
  return std::upper_bound(timetable.places.begin(), timetable.places.end(), time,
                          [](std::int64_t at, const TimedPlace& place) { return at < place.time; });
}

/// How many whole passages lie before the time.
std::int64_t passages_before(const Timetable& timetable, std::int64_t time) {
  if (!timetable.repeat || time < timetable.begin()) return 0;
  return (time - timetable.begin()) / timetable.period();
}

}  // namespace

double turn_between_deg(const Pose& X_first, const Pose& X_second) {
  return math::rotation_angle_deg(X_second.linear() * X_first.linear().transpose());
}

Pose pose_at(const Timetable& timetable, std::int64_t time) {
  time -= passages_before(timetable, time) * timetable.period();
  const auto second = place_after(timetable, time);
  if (second == timetable.places.begin()) return timetable.places.front().X_WO;
  if (second == timetable.places.end()) return timetable.places.back().X_WO;
  const TimedPlace& first = *(second - 1);
  return pose_between(first.X_WO, second->X_WO, turn_between(first.X_WO, second->X_WO),
                      share_of(first, *second, time));
}

std::vector<TimedMotion> motions_between(const Timetable& timetable, std::int64_t from,
                                         std::int64_t to) {
  assert(from < to);
  std::vector<TimedMotion> motions;
  std::int64_t time = from;
  while (time < to) {
    const std::int64_t passed = passages_before(timetable, time) * timetable.period();
    const auto second = place_after(timetable, time - passed);
    if (second == timetable.places.begin() || second == timetable.places.end()) {
      const bool before = second == timetable.places.begin();
      const std::int64_t until = before ? std::min(to, timetable.begin()) : to;
      const TimedPlace& place = before ? timetable.places.front() : timetable.places.back();
      motions.push_back({time, until, stationary(place.X_WO)});
      time = until;
      continue;
    }
    const std::int64_t until = std::min(to, passed + second->time);
    motions.push_back(
        {time, until, motion_of(*(second - 1), *second, time - passed, until - passed)});
    time = until;
  }
  return motions;
}

}  // namespace rubicon::geometry
