#include "src/motion/guides/leg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::guides {

namespace {

/// Part of its step by which a parameter is at a value (LANGUAGE 4).
constexpr double kThere = 1e-6;

/// Part of what counts as there by which a vehicle may pass beside its target: what is less needs
/// no turn. More than the coordinates of a site in a national grid are rounded by.
constexpr double kBeside = 0.25;

/// A chord that is exactly a step may be longer by rounding.
constexpr double kLongerChord = 1 + 1e-9;

using math::at;

}  // namespace

Leg::Leg(const robot::RobotModel& model, const robot::Mounting& mounting,
         const robot::GoalClauses& clauses, double turn_radius)
    : model_(model), mounting_(mounting), turn_radius_(turn_radius) {
  find_vehicle();
  const auto locked = [&](int i) { return i >= 0 && clauses.locks(i); };
  if (locked(drive_) || locked(heading_) || locked(place_[0]) || locked(place_[1])) {
    drive_ = heading_ = place_[0] = place_[1] = -1;
  }
  for (int i = 0; i < static_cast<int>(model.parameters.size()); ++i) {
    const robot::Parameter& p = parameter(i);
    if (p.derived) continue;
    if (p.step > 0) stepped_.push_back(i);
    if (clauses.locks(i)) continue;
    const bool driven = i == place_[0] || i == place_[1];
    const bool plain = p.step > 0 && (p.direct || i == heading_);
    if (plain) plain_.push_back(i);
    if (driven || plain) parameters_.push_back(i);
  }
  if (refusal_.empty() && stepped_.empty()) refusal_ = "no parameter of it has a step or a speed";
}

std::vector<int> Leg::parameters_driven_by(int drive) const {
  std::vector<int> driven;
  for (int i = 0; i < static_cast<int>(model_.parameters.size()); ++i) {
    const robot::Parameter& p = parameter(i);
    if (!p.derived && !p.direct && p.rule.depends_on_step(drive)) driven.push_back(i);
  }
  return driven;
}

/// Finds what a vehicle drives by; or why the rules are those of no machine that makes legs.
void Leg::find_vehicle() {
  for (int i = 0; i < static_cast<int>(model_.parameters.size()); ++i) {
    const robot::Parameter& p = parameter(i);
    if (p.derived || p.direct || !(p.step > 0) || turns_alone(i)) continue;
    if (drive_ >= 0 || p.rotation) {
      refusal_ = fmt::format("the rule of {} is neither plain nor that of one local parameter",
                             p.display_name);
      return;
    }
    drive_ = i;
  }
  if (drive_ < 0) return;
  const std::string& name = parameter(drive_).display_name;
  const std::vector<int> driven = parameters_driven_by(drive_);
  for (int i = 0; i < static_cast<int>(model_.parameters.size()); ++i) {
    const robot::Parameter& p = parameter(i);
    const bool turns = p.rotation && p.step > 0 && !p.derived && (p.direct || turns_alone(i));
    if (turns && p.body == parameter(drive_).body) heading_ = i;
  }
  if (heading_ < 0 || driven.size() != 2 || parameter(driven[0]).rotation ||
      parameter(driven[1]).rotation) {
    refusal_ = fmt::format("{} drives it along no heading that it can turn", name);
    return;
  }
  place_[0] = driven[0];
  place_[1] = driven[1];
  if (!turns_with_heading()) {
    refusal_ = fmt::format("the way that {} drives it does not turn with {}", name,
                           parameter(heading_).display_name);
    return;
  }
  std::vector<double> q = model_.start_values();
  q[at(heading_)] = 0;
  double x = 0;
  double y = 0;
  direction(q, x, y);
  drift_deg_ = math::atan2_deg(y, x);
  chords_ = drives_chords();
}

/// Whether a step of an angle alone turns it by that step and changes nothing else of its body,
/// though rules of others read it: of a vehicle that turns while it drives.
bool Leg::turns_alone(int index) const {
  const robot::Parameter& p = parameter(index);
  if (!p.rotation || p.derived || p.direct || !(p.step > 0)) return false;
  constexpr double kSame = 1e-9;
  for (const double shift : {0.0, 37.3}) {
    std::vector<double> q = model_.start_values();
    for (double& value : q) value += shift;
    std::vector<double> steps(q.size(), 0.0);
    std::vector<double> next(q.size());
    steps[at(index)] = 1;
    robot::apply_rules(model_, mounting_, q, steps, next);
    for (int i = 0; i < static_cast<int>(q.size()); ++i) {
      if (parameter(i).derived) continue;
      if (std::fabs(next[at(i)] - q[at(i)] - (i == index ? 1 : 0)) > kSame) return false;
    }
  }
  return true;
}

/// Whether a step that turns by an angle leads along the chord of an arc of that angle.
bool Leg::drives_chords() const {
  std::vector<double> q = model_.start_values();
  double x = 0;
  double y = 0;
  constexpr double kSame = 1e-9;
  constexpr double kTurned = 10;
  q[at(heading_)] = kTurned / 2;
  direction(q, x, y);
  q[at(heading_)] = 0;
  std::vector<double> steps(q.size(), 0.0);
  std::vector<double> next(q.size());
  steps[at(heading_)] = kTurned;
  steps[at(drive_)] = 1;
  robot::apply_rules(model_, mounting_, q, steps, next);
  return std::fabs(next[at(place_[0])] - q[at(place_[0])] - x) <= kSame &&
         std::fabs(next[at(place_[1])] - q[at(place_[1])] - y) <= kSame &&
         std::fabs(next[at(heading_)] - kTurned) <= kSame;
}

void Leg::direction(std::span<const double> q, double& along_x, double& along_y) const {
  std::vector<double> steps(q.size(), 0.0);
  std::vector<double> next(q.size());
  steps[at(drive_)] = 1;
  robot::apply_rules(model_, mounting_, q, steps, next);
  along_x = next[at(place_[0])] - q[at(place_[0])];
  along_y = next[at(place_[1])] - q[at(place_[1])];
}

/// Whether a metre driven is a metre on the plan, in a direction that turns as the heading does.
bool Leg::turns_with_heading() const {
  std::vector<double> q = model_.start_values();
  constexpr double kSame = 1e-9;
  double x0 = 0;
  double y0 = 0;
  q[at(heading_)] = 0;
  direction(q, x0, y0);
  for (const double heading_deg : {30.0, 90.0, -120.0}) {
    double x = 0;
    double y = 0;
    q[at(heading_)] = heading_deg;
    direction(q, x, y);
    const double cosine = math::cos_deg(heading_deg);
    const double sine = math::sin_deg(heading_deg);
    if (std::fabs(x - (x0 * cosine - y0 * sine)) > kSame) return false;
    if (std::fabs(y - (x0 * sine + y0 * cosine)) > kSame) return false;
    if (std::fabs(std::sqrt(x * x + y * y) - 1) > kSame) return false;
  }
  return true;
}

double Leg::heading_along(std::span<const double> q, const Eigen::Vector2d& direction_W) const {
  const math::Mat3 R_MW = mounting_.X_WM.linear().transpose();
  const math::Vec3 wanted = R_MW * math::Vec3(direction_W.x(), direction_W.y(), 0);
  double x = 0;
  double y = 0;
  direction(q, x, y);
  const double beside = x * wanted.y() - y * wanted.x();
  const double ahead = x * wanted.x() + y * wanted.y();
  return robot::reduced(parameter(heading_), q[at(heading_)] + math::atan2_deg(beside, ahead));
}

double Leg::missing(int index, std::span<const double> q, std::span<const double> target) const {
  const robot::Parameter& p = parameter(index);
  const double off = robot::way_between(p, q[at(index)], target[at(index)]);
  return std::fabs(off) <= kThere * p.quantum ? 0 : off;
}

double Leg::most_beside() const { return kBeside * kThere * parameter(drive_).quantum; }

Leg::Facing Leg::facing(std::span<const double> q, std::span<const double> target) const {
  Facing result;
  if (drive_ < 0) return result;
  const double dx = target[at(place_[0])] - q[at(place_[0])];
  const double dy = target[at(place_[1])] - q[at(place_[1])];
  result.distance = std::sqrt(dx * dx + dy * dy);
  if (result.distance <= kThere * parameter(drive_).quantum) return result;
  result.there = false;
  double x = 0;
  double y = 0;
  direction(q, x, y);
  const double beside = x * dy - y * dx;
  const double ahead = x * dx + y * dy;
  if (std::fabs(beside) <= most_beside() && ahead > 0) return result;
  result.turn = math::atan2_deg(beside, ahead);
  return result;
}

bool Leg::next_step(std::span<const double> q, std::span<const double> target,
                    std::span<double> steps) const {
  std::fill(steps.begin(), steps.end(), 0.0);
  if (steers() && next_chord(q, target, steps)) return true;
  if (const Facing face = facing(q, target); !face.there) {
    turn_or_drive(face.turn, face.turn != 0, face.distance, steps);
    return true;
  }
  double share = 1;
  bool something = false;
  for (const int i : plain_) {
    const double off = missing(i, q, target);
    steps[at(i)] = off;
    if (off == 0) continue;
    something = true;
    share = std::min(share, parameter(i).step / std::fabs(off));
  }
  if (share < 1) {
    for (const int i : plain_) steps[at(i)] *= share;
  }
  return something;
}

/// Turns first and drives then. A turn too small to be a step is made while it drives: a step of
/// its own would leave it where it is, as far as can be told.
void Leg::turn_or_drive(double turn, bool must_turn, double distance,
                        std::span<double> steps) const {
  const double most = parameter(heading_).step;
  const double farthest = parameter(drive_).step;
  if (must_turn) steps[at(heading_)] = std::clamp(turn, -most, most);
  if (must_turn && std::fabs(turn) > kThere * parameter(heading_).quantum) return;
  steps[at(drive_)] = std::clamp(distance, -farthest, farthest);
}

bool Leg::is_there(std::span<const double> q, std::span<const double> target) const {
  if (!facing(q, target).there) return false;
  return std::all_of(plain_.begin(), plain_.end(),
                     [&](int i) { return missing(i, q, target) == 0; });
}

std::vector<std::vector<double>> Leg::corners(std::span<const double> q,
                                              std::span<const double> target) const {
  if (steers()) return steered_corners(q, target, false);
  std::vector<std::vector<double>> result;
  std::vector<double> now(q.begin(), q.end());
  std::vector<double> steps(q.size(), 0.0);
  std::vector<double> next(q.size());
  const auto go = [&] {
    robot::apply_rules(model_, mounting_, now, steps, next);
    result.push_back(next);
    now = next;
    std::fill(steps.begin(), steps.end(), 0.0);
  };
  if (Facing face = facing(now, target); !face.there) {
    if (face.turn != 0) {
      steps[at(heading_)] = face.turn;
      go();
    }
    steps[at(drive_)] = face.distance;
    go();
  }
  bool something = false;
  for (const int i : plain_) {
    steps[at(i)] = robot::way_between(parameter(i), now[at(i)], target[at(i)]);
    something = something || steps[at(i)] != 0;
  }
  if (something) go();
  return result;
}

PlanePose Leg::plane_pose(std::span<const double> q) const {
  return {q[at(place_[0])], q[at(place_[1])], q[at(heading_)] + drift_deg_};
}

ReedsSheppWay Leg::steered(std::span<const double> q, std::span<const double> target) const {
  return reeds_shepp_way(plane_pose(q), plane_pose(target), turn_radius_);
}

double Leg::driven(std::span<const double> q, std::span<const double> target) const {
  return steered(q, target).length();
}

std::vector<double> Leg::driven_by(std::span<const double> q, const PlanePart& part) const {
  std::vector<double> result(q.begin(), q.end());
  const PlanePose pose = after(plane_pose(q), part);
  result[at(place_[0])] = pose.x;
  result[at(place_[1])] = pose.y;
  result[at(heading_)] = robot::reduced(parameter(heading_), pose.heading_deg - drift_deg_);
  return result;
}

std::vector<double> Leg::partway(std::span<const double> q, std::span<const double> target,
                                 double share) const {
  std::vector<double> result(q.begin(), q.end());
  for (const int i : plain_) {
    if (i == heading_) continue;
    result[at(i)] += share * robot::way_between(parameter(i), q[at(i)], target[at(i)]);
  }
  const ReedsSheppWay way = steered(q, target);
  double left = share * way.length();
  PlanePose pose = plane_pose(q);
  for (const PlanePart& part : way.parts) {
    const double length = std::fabs(part.driven);
    const double of_part = left < length ? left / length : 1;
    pose = after(pose, {part.turned_deg * of_part, part.driven * of_part});
    left -= length;
    if (left <= 0) break;
  }
  result[at(place_[0])] = pose.x;
  result[at(place_[1])] = pose.y;
  result[at(heading_)] = robot::reduced(parameter(heading_), pose.heading_deg - drift_deg_);
  return result;
}

std::vector<std::vector<double>> Leg::stops(std::span<const double> q,
                                            std::span<const double> target) const {
  if (steers()) return steered_corners(q, target, true);
  return {std::vector<double>(target.begin(), target.end())};
}

std::vector<std::vector<double>> Leg::steered_corners(std::span<const double> q,
                                                      std::span<const double> target,
                                                      bool stops_only) const {
  std::vector<std::vector<double>> result;
  std::vector<double> now(q.begin(), q.end());
  std::vector<double> steps(q.size(), 0.0);
  std::vector<double> next(q.size());
  const auto go = [&](double turned_deg, double driven, bool stop) {
    if (turned_deg == 0 && driven == 0) return;
    steps[at(heading_)] = turned_deg;
    steps[at(drive_)] = driven;
    robot::apply_rules(model_, mounting_, now, steps, next);
    if (stop || !stops_only) result.push_back(next);
    now = next;
  };
  for (const PlanePart& part : steered(q, target).parts) {
    const double turned = std::fabs(part.turned_deg);
    const double chords =
        part.turned_deg == 0 ? 1
                             : std::ceil(std::max(turned / parameter(heading_).step,
                                                  std::fabs(part.driven) / parameter(drive_).step) /
                                         kLongerChord);
    const double turn = part.turned_deg / chords;
    const double half = math::sin_deg(turn / 2);
    const double chord =
        turn == 0 ? part.driven : 2 * part.driven / math::radians(part.turned_deg) * half;
    for (int i = 0; i < static_cast<int>(chords); ++i) {
      if (chords_) {
        go(turn, chord, true);
        continue;
      }
      go(turn / 2, 0, false);
      go(0, chord, turn == 0);
      go(turn / 2, 0, true);
    }
  }
  std::fill(steps.begin(), steps.end(), 0.0);
  bool something = false;
  for (const int i : plain_) {
    if (i == heading_) continue;
    steps[at(i)] = robot::way_between(parameter(i), now[at(i)], target[at(i)]);
    something = something || steps[at(i)] != 0;
  }
  if (something) {
    robot::apply_rules(model_, mounting_, now, steps, next);
    result.push_back(next);
  }
  return result;
}

/// The next step along one chord, or along a straight way: forwards or backwards, whichever way it
/// has to turn less for. False: it is there.
bool Leg::next_chord(std::span<const double> q, std::span<const double> target,
                     std::span<double> steps) const {
  Facing face = facing(q, target);
  if (face.there) return false;
  if (std::fabs(face.turn) > 90) {
    face.turn = math::normalised_deg(face.turn + 180);
    face.distance = -face.distance;
  }
  const double drive_step = parameter(drive_).step;
  const double turn = missing(heading_, q, target);
  const double beside = face.distance * math::sin_deg(face.turn - turn / 2);
  const bool on_chord = std::fabs(beside) <= most_beside() &&
                        std::fabs(face.distance) <= drive_step * kLongerChord &&
                        std::fabs(turn) <= parameter(heading_).step * kLongerChord;
  if (chords_ && on_chord) {
    steps[at(heading_)] = turn;
    steps[at(drive_)] = face.distance;
  } else {
    const bool is_beside = std::fabs(face.distance * math::sin_deg(face.turn)) > most_beside();
    turn_or_drive(face.turn, is_beside, face.distance, steps);
  }
  return true;
}

}  // namespace rubicon::guides
