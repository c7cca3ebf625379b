#include "src/motion/robot/goal_problem.hpp"

#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::robot {
namespace {

/// Twice the sine of an angle below which a half turn's axis is read off the symmetric part of the
/// matrix.
constexpr double kHalfTurn = 1e-6;

/// Rotation vector (radians, world) of R.
Vec3 rotation_vector(const math::Mat3& R) {
  Vec3 twice_sine(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double length = twice_sine.norm();
  const double angle = math::radians(math::rotation_angle_deg(R));
  if (length > kHalfTurn || angle < 1)
    return length > 0 ? Vec3(twice_sine * (angle / length)) : Vec3::Zero();
  // Near a half turn R + I is twice the outer product of the axis.
  const math::Mat3 outer = R + math::Mat3::Identity();
  int largest = 0;
  for (int i = 1; i < 3; ++i) {
    if (outer(i, i) > outer(largest, largest)) largest = i;
  }
  const Vec3 axis = outer.col(largest).normalized();
  return (axis.dot(twice_sine) < 0 ? -angle : angle) * axis;
}

}  // namespace

GoalProblem::GoalProblem(const RobotModel& model, const Mounting& mounting,
                         std::span<const double> q_now, const Pose& X_WG)
    : model_(model),
      mounting_(mounting),
      q_now_(q_now.begin(), q_now.end()),
      X_WG_(X_WG),
      elements_(elements_to_tool(model)) {
  int level = 0;
  for (int b = model.tool_body; b >= 0;
       b = model.bodies[static_cast<std::size_t>(b)].parent, ++level) {
    for (std::size_t i = 0; i < model.parameters.size(); ++i) {
      const Parameter& parameter = model.parameters[i];
      if (parameter.body != b || !parameter.free || parameter.derived) continue;
      variables_.push_back({i, level, parameter.rotation ? 180 / math::kPi : 1});
    }
  }
  for (const Parameter& parameter : model.parameters)
    has_derived_ = has_derived_ || parameter.derived;
}

GoalState GoalProblem::at(std::vector<double> q) const {
  work_ += elements_.size();
  GoalState state;
  state.q = std::move(q);
  if (has_derived_) update_derived(model_, mounting_, state.q);
  const Pose X_WT = tool_pose(model_, mounting_, state.q);
  state.residual.head<3>() = X_WG_.translation() - X_WT.translation();
  state.residual.tail<3>() = rotation_vector(X_WG_.linear() * X_WT.linear().transpose());
  state.position_error = state.residual.head<3>().norm();
  state.orientation_error = state.residual.tail<3>().norm();
  return state;
}

PoseJacobian GoalProblem::jacobian(const GoalState& state, std::size_t count) const {
  work_ += elements_.size() * (1 + count);
  const FormulaInput input = {state.q, {}, mounting_.starts};
  std::vector<std::vector<double>> rates;
  if (has_derived_) {
    for (std::size_t v = 0; v < count; ++v) {
      rates.push_back(
          rates_by(model_, mounting_, state.q, static_cast<int>(variables_[v].parameter)));
    }
  }
  const auto derivative = [&](const Formula& formula, std::size_t v) {
    return has_derived_ ? formula.derivative(input, rates[v])
                        : formula.derivative(input, static_cast<int>(variables_[v].parameter));
  };

  PoseJacobian jacobian = PoseJacobian::Zero(6, static_cast<Eigen::Index>(count));
  const Vec3 p_WT = X_WG_.translation() - state.residual.head<3>();
  Pose X = mounting_.X_WM;
  for (const FrameElement* element : elements_) {
    for (std::size_t v = 0; v < count; ++v) {
      const auto column = static_cast<Eigen::Index>(v);
      const double scale = variables_[v].scale;
      if (element->kind == FrameElement::Kind::trans) {
        const Vec3 rate(derivative(element->a, v), derivative(element->b, v),
                        derivative(element->c, v));
        jacobian.col(column).head<3>() += X.linear() * (rate * scale);
      } else if (const double rate = derivative(element->a, v); rate != 0) {
        const Vec3 turn = X.linear() * rotation_axis(element->kind) * math::radians(rate * scale);
        const Vec3 arm = p_WT - Vec3(X.translation());
        jacobian.col(column).head<3>() += turn.cross(arm);
        jacobian.col(column).tail<3>() += turn;
      }
    }
    append(X, *element, input);
  }
  return jacobian;
}

double GoalProblem::moved(const GoalState& state, std::size_t variable) const {
  const std::size_t i = variables_[variable].parameter;
  const double change = state.q[i] - q_now_[i];
  return reduced(parameter(variable), change) / variables_[variable].scale;
}

bool GoalProblem::better(const GoalState& a, const GoalState& b) const {
  if (std::fabs(a.position_error - b.position_error) > kSolved)
    return a.position_error < b.position_error;
  if (std::fabs(a.orientation_error - b.orientation_error) > kSolved)
    return a.orientation_error < b.orientation_error;
  for (std::size_t v = variables_.size(); v > 0;) {
    const int level = variables_[v - 1].level;
    double a_squared = 0;
    double b_squared = 0;
    for (; v > 0 && variables_[v - 1].level == level; --v) {
      const double a_moved = moved(a, v - 1);
      const double b_moved = moved(b, v - 1);
      a_squared += a_moved * a_moved;
      b_squared += b_moved * b_moved;
    }
    const double difference = std::sqrt(a_squared) - std::sqrt(b_squared);
    if (std::fabs(difference) > kSolved) return difference < 0;
  }
  return false;
}

}  // namespace rubicon::robot
