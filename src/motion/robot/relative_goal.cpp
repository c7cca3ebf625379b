#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/inline_buffer.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::robot {
namespace {

/// Part of the smallest translation step below which the goal counts as met and has no bearing
/// (LANGUAGE 6.2); without it rounding noise turns a robot on the spot when it has arrived.
constexpr double kArrived = 1e-5;

/// Sine of the angle between reference axis and rotation axis below which the body has no heading
/// about that axis.
constexpr double kNoHeading = 1e-9;

double translation_goal(const RobotModel& model, const Mounting& mounting,
                        std::span<const double> q, std::size_t parameter, const Vec3& p_WG) {
  InlineBuffer<double> steps(q.size());
  InlineBuffer<double> moved(q.size());
  for (double& step : steps.span()) step = 0;
  steps[parameter] = 1;
  apply_rules(model, mounting, q, steps.span(), moved.span());
  const Vec3 p_WT = tool_pose(model, mounting, q).translation();
  const Vec3 u = Vec3(tool_pose(model, mounting, moved.span()).translation()) - p_WT;
  const double length_squared = u.dot(u);
  return length_squared > 0 ? q[parameter] + (p_WG - p_WT).dot(u) / length_squared : q[parameter];
}

double rotation_goal(const RobotModel& model, const Mounting& mounting, std::span<const double> q,
                     std::size_t index, const Vec3& p_WG) {
  const Parameter& parameter = model.parameters[index];
  const Body& body = model.bodies[static_cast<std::size_t>(parameter.body)];
  const FormulaInput input = {q, {}, mounting.starts};

  Pose X = body.parent < 0 ? mounting.X_WM : body_pose(model, mounting, q, body.parent);
  double rate = 0;  // degrees of the element's angle for a degree of the parameter
  Vec3 axis = Vec3::Zero();
  Vec3 on_axis = Vec3::Zero();
  for (const FrameElement& element : body.frame) {
    if (rate == 0 && element.kind != FrameElement::Kind::trans) {
      rate = element.a.derivative(input, static_cast<int>(index));
      axis = X.linear() * rotation_axis(element.kind);
      on_axis = X.translation();
    }
    append(X, element, input);
  }
  if (rate == 0) return q[index];

  const Vec3 reference = X.linear().col(parameter.name == "psi" ? 1 : 0);
  Pose X_WT = body_pose(model, mounting, q, model.tool_body);
  append(X_WT, model.tool_frame, input);
  const Vec3 centre = on_axis + axis * axis.dot(Vec3(X_WT.translation()) - on_axis);

  const Vec3 w = (p_WG - centre) - axis * axis.dot(p_WG - centre);
  const Vec3 e = reference - axis * axis.dot(reference);
  if (w.norm() < kArrived * model.smallest_translation_step() || e.norm() < kNoHeading)
    return q[index];
  return q[index] + math::atan2_deg(axis.dot(e.cross(w)), e.dot(w)) / rate;
}

}  // namespace

double relative_goal(const RobotModel& model, const Mounting& mounting, std::span<const double> q,
                     int parameter, const Vec3& p_WG) {
  const auto index = static_cast<std::size_t>(parameter);
  const Parameter& chosen = model.parameters[index];
  if (!chosen.rotation) return translation_goal(model, mounting, q, index, p_WG);
  const double value = rotation_goal(model, mounting, q, index, p_WG);
  return reduced(chosen, nearest_turn_equivalent(chosen, value, q[index]));
}

}  // namespace rubicon::robot
