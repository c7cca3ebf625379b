#include "src/results/verify/input/mechanism.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::verify {

namespace {

using math::at;

Pose element_pose(FrameElement::Kind kind, const Vec3& value) {
  switch (kind) {
    case FrameElement::Kind::trans:
      return math::translation(value.x(), value.y(), value.z());
    case FrameElement::Kind::rotx:
      return math::rotation_x_deg(value.x());
    case FrameElement::Kind::roty:
      return math::rotation_y_deg(value.x());
    case FrameElement::Kind::rotz:
      return math::rotation_z_deg(value.x());
  }
  return Pose::Identity();
}

Vec3 element_axis(FrameElement::Kind kind) {
  switch (kind) {
    case FrameElement::Kind::rotx:
      return Vec3::UnitX();
    case FrameElement::Kind::roty:
      return Vec3::UnitY();
    default:
      return Vec3::UnitZ();
  }
}

Vec3 element_value(const FrameElement& element, const FormulaValues& values) {
  if (element.kind != FrameElement::Kind::trans) return {element.a.value(values), 0, 0};
  return {element.a.value(values), element.b.value(values), element.c.value(values)};
}

/// The values of a formula in an interval, and how far they deviate from the one at its middle.
class ElementRange {
 public:
  ElementRange(std::span<const double> from, std::span<const double> to,
               std::span<const double> starts)
      : starts_(starts) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      ranges_.push_back({std::min(from[i], to[i]), std::max(from[i], to[i])});
      if (from[i] != to[i]) moving_.push_back(i);
    }
  }

  bool changes(const FrameElement& element) const {
    return std::any_of(moving_.begin(), moving_.end(), [&](std::size_t i) {
      return element.a.uses(i) || element.b.uses(i) || element.c.uses(i);
    });
  }

  double half(const Formula& formula, double middle) const {
    const Range range = formula.range(ranges_, starts_);
    return std::max({range.upper - middle, middle - range.lower, 0.0});
  }

 private:
  std::span<const double> starts_;
  std::vector<Range> ranges_;
  std::vector<std::size_t> moving_;
};

}  // namespace

Mechanism::Mechanism(const SceneRobot& robot) : robot_(&robot) {
  for (const SceneBody& body : robot.bodies) {
    parents_.push_back(body.parent);
    frames_.push_back(&body.frame);
  }
  parents_.push_back(robot.tool_body);
  frames_.push_back(&robot.tool_frame);
}

Pose Mechanism::pose(int frame, std::span<const double> q) const {
  const FormulaValues values{q, {}, robot_->starts};
  Pose X = Pose::Identity();
  for (; frame >= 0; frame = parents_[at(frame)]) {
    Pose X_PB = Pose::Identity();
    for (const FrameElement& element : *frames_[at(frame)]) {
      X_PB = X_PB * element_pose(element.kind, element_value(element, values));
    }
    X = X_PB * X;
  }
  return robot_->X_WM * X;
}

MechanismState Mechanism::state(std::span<const double> from, std::span<const double> to) const {
  std::vector<double> middle(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    middle[i] = from[i] == to[i] ? from[i] : from[i] + (to[i] - from[i]) / 2;
  }
  const FormulaValues values{middle, {}, robot_->starts};
  const ElementRange ranges(from, to, robot_->starts);
  MechanismState state;
  for (std::size_t frame = 0; frame < parents_.size(); ++frame) {
    Pose X = parents_[frame] < 0 ? robot_->X_WM : state.X_WB[at(parents_[frame])];
    for (const FrameElement& element : *frames_[frame]) {
      const Vec3 value = element_value(element, values);
      if (ranges.changes(element)) {
        MechanismState::Change change{static_cast<int>(frame), element.kind, X, Vec3::Zero()};
        change.half.x() = ranges.half(element.a, value.x());
        if (element.kind == FrameElement::Kind::trans) {
          change.half.y() = ranges.half(element.b, value.y());
          change.half.z() = ranges.half(element.c, value.z());
        } else {
          change.half.x() = math::radians(change.half.x());
        }
        state.changes.push_back(change);
      }
      X = X * element_pose(element.kind, value);
    }
    state.X_WB.push_back(X);
  }
  return state;
}

bool Mechanism::stands_on(int frame, int base) const {
  while (frame > base) frame = parents_[at(frame)];
  return frame == base;
}

int Mechanism::common_frame(int a, int b) const {
  while (a != b) {
    int& deeper = a > b ? a : b;  // a frame comes after the one it stands on
    deeper = parents_[at(deeper)];
  }
  return a;
}

Reach Mechanism::reach(const MechanismState& state, int frame, int base, const Vec3& centre_W,
                       double radius) const {
  Reach reach;
  bool turned = false;  // by an element before: then the direction of a move does not stand still
  for (const MechanismState::Change& change : state.changes) {
    const bool below = change.frame == frame || stands_on(frame, change.frame);
    const bool seen = base < 0 || !(change.frame == base || stands_on(base, change.frame));
    if (!below || !seen) continue;
    if (change.kind == FrameElement::Kind::trans) {
      if (turned) {
        reach.rest += change.half.norm();
      } else {
        reach.spread += change.X_WE.linear().cwiseAbs() * change.half;
      }
      continue;
    }
    turned = true;
    const Vec3 axis = change.X_WE.linear() * element_axis(change.kind);
    const Vec3 arm = centre_W - change.X_WE.translation();
    reach.rest += change.half.x() * (arm.cross(axis).norm() + radius);
  }
  return reach;
}

}  // namespace rubicon::verify
