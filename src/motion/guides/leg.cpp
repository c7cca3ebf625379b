#include "src/motion/guides/leg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::guides {

namespace {

/// Part of its step by which a parameter is at a value (LANGUAGE 4).
constexpr double kThere = 1e-6;

/// m by which a vehicle may pass beside its target. Far below what counts as there.
constexpr double kBeside = 1e-9;

using math::at;

}  // namespace

Leg::Leg(const robot::RobotModel& model, const robot::Mounting& mounting,
         const robot::GoalClauses& clauses)
    : model_(model), mounting_(mounting) {
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
    if (p.step > 0 && p.direct) plain_.push_back(i);
    if (driven || (p.step > 0 && p.direct)) parameters_.push_back(i);
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
    if (p.derived || p.direct || !(p.step > 0)) continue;
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
    if (p.rotation && p.direct && p.step > 0 && p.body == parameter(drive_).body) heading_ = i;
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
  }
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
  if (std::fabs(beside) <= kBeside && ahead > 0) return result;
  result.turn = math::atan2_deg(beside, ahead);
  return result;
}

bool Leg::next_step(std::span<const double> q, std::span<const double> target,
                    std::span<double> steps) const {
  std::fill(steps.begin(), steps.end(), 0.0);
  if (const Facing face = facing(q, target); !face.there) {
    const int moved = face.turn != 0 ? heading_ : drive_;
    const double off = face.turn != 0 ? face.turn : face.distance;
    steps[at(moved)] = std::clamp(off, -parameter(moved).step, parameter(moved).step);
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

bool Leg::is_there(std::span<const double> q, std::span<const double> target) const {
  if (!facing(q, target).there) return false;
  return std::all_of(plain_.begin(), plain_.end(),
                     [&](int i) { return missing(i, q, target) == 0; });
}

std::vector<std::vector<double>> Leg::corners(std::span<const double> q,
                                              std::span<const double> target) const {
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

}  // namespace rubicon::guides
