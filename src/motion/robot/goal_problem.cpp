#include "src/motion/robot/goal_problem.hpp"

#include <cmath>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::robot {
namespace {

/// The parameters that those of a body are derived from, through others too.
std::vector<bool> sources_of(const RobotModel& model, int body) {
  const std::size_t count = model.parameters.size();
  std::vector<bool> sources(count, false);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < count; ++i) {
    if (model.parameters[i].body == body && model.parameters[i].derived) left.push_back(i);
  }
  while (!left.empty()) {
    const Formula& formula = model.parameters[left.back()].derived_value;
    left.pop_back();
    for (std::size_t i = 0; i < count; ++i) {
      if (sources[i] || !formula.depends_on_parameter(static_cast<int>(i))) continue;
      sources[i] = true;
      if (model.parameters[i].derived) left.push_back(i);
    }
  }
  return sources;
}

}  // namespace

GoalChain::GoalChain(const RobotModel& model, GoalClauses clauses)
    : model_(model), clauses_(std::move(clauses)), elements_(elements_to_tool(model)) {
  std::vector<bool> is_on_chain(model.bodies.size(), false);
  for (int b = model.tool_body; b >= 0; b = model.bodies[static_cast<std::size_t>(b)].parent) {
    is_on_chain[static_cast<std::size_t>(b)] = true;
  }
  std::vector<bool> is_taken(model.parameters.size(), false);
  bool is_any_beside = false;
  for (std::size_t i = 0; i < model.parameters.size(); ++i) {
    const Parameter& parameter = model.parameters[i];
    has_derived_ = has_derived_ || parameter.derived;
    is_taken[i] = !parameter.free || parameter.derived || clauses_.locks(static_cast<int>(i));
    is_any_beside =
        is_any_beside || (!is_taken[i] && !is_on_chain[static_cast<std::size_t>(parameter.body)]);
  }
  const auto take = [&](std::size_t i, int level) {
    const bool named =
        std::any_of(clauses_.near.begin(), clauses_.near.end(),
                    [i](const auto& each) { return static_cast<std::size_t>(each.first) == i; });
    variables_.push_back({i, level, model.parameters[i].rotation ? 180 / math::kPi : 1, named});
    is_taken[i] = true;
  };
  int level = 0;
  for (int b = model.tool_body; b >= 0;
       b = model.bodies[static_cast<std::size_t>(b)].parent, ++level) {
    for (std::size_t i = 0; i < model.parameters.size(); ++i) {
      if (model.parameters[i].body == b && !is_taken[i]) take(i, level);
    }
    if (!is_any_beside || !has_derived_) continue;
    // A drum beside the chain lifts the hook by what is derived from it.
    const std::vector<bool> sources = sources_of(model, b);
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (sources[i] && !is_taken[i] &&
          !is_on_chain[static_cast<std::size_t>(model.parameters[i].body)]) {
        take(i, level);
      }
    }
  }
}

GoalState GoalProblem::at(std::vector<double> q) const {
  work_ += elements().size();
  GoalState state;
  state.q = std::move(q);
  if (chain_.has_derived()) update_derived(model(), mounting_, state.q);
  const Pose X_WT = tool_pose(model(), mounting_, state.q);
  state.residual.head<3>() = X_WG_.translation() - X_WT.translation();
  state.residual.tail<3>() = turn_to_goal(X_WT.linear(), X_WG_.linear(), chain_.clauses().free);
  state.position_error = state.residual.head<3>().norm();
  state.orientation_error = state.residual.tail<3>().norm();
  return state;
}

PoseJacobian GoalProblem::jacobian(const GoalState& state, std::size_t count) const {
  work_ += elements().size() * (1 + count);
  const FormulaInput input = {state.q, {}, mounting_.starts};
  std::vector<std::vector<double>> rates;
  if (chain_.has_derived()) {
    for (std::size_t v = 0; v < count; ++v) {
      rates.push_back(
          rates_by(model(), mounting_, state.q, static_cast<int>(variables()[v].parameter)));
    }
  }
  const auto derivative = [&](const Formula& formula, std::size_t v) {
    return chain_.has_derived()
               ? formula.derivative(input, rates[v])
               : formula.derivative(input, static_cast<int>(variables()[v].parameter));
  };

  PoseJacobian jacobian = PoseJacobian::Zero(6, static_cast<Eigen::Index>(count));
  const Vec3 p_WT = X_WG_.translation() - state.residual.head<3>();
  Pose X = mounting_.X_WM;
  for (const FrameElement* element : elements()) {
    for (std::size_t v = 0; v < count; ++v) {
      const auto column = static_cast<Eigen::Index>(v);
      const double scale = variables()[v].scale;
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
  if (chain_.clauses().free != FreeTurn::none) {
    const math::Mat3 R_WT = tool_pose(model(), mounting_, state.q).linear();
    for (Eigen::Index v = 0; v < jacobian.cols(); ++v) {
      jacobian.col(v).tail<3>() =
          turn_that_counts(jacobian.col(v).tail<3>(), R_WT, chain_.clauses().free);
    }
  }
  return jacobian;
}

double GoalProblem::moved(const GoalState& state, std::size_t variable) const {
  const std::size_t i = variables()[variable].parameter;
  const double change = state.q[i] - q_now_[i];
  return reduced(parameter(variable), change) / variables()[variable].scale;
}

/// From the values at which the search begins: those that `near` names.
double GoalProblem::from_named(const GoalState& state) const {
  double squared = 0;
  for (std::size_t v = 0; v < variables().size(); ++v) {
    if (!variables()[v].named) continue;
    const double off = moved(state, v);
    squared += off * off;
  }
  return std::sqrt(squared);
}

bool GoalProblem::better(const GoalState& a, const GoalState& b) const {
  if (std::fabs(a.position_error - b.position_error) > kSolved)
    return a.position_error < b.position_error;
  if (std::fabs(a.orientation_error - b.orientation_error) > kSolved)
    return a.orientation_error < b.orientation_error;
  if (chain_.has_named()) {
    const double difference = from_named(a) - from_named(b);
    if (std::fabs(difference) > kSolved) return difference < 0;
  }
  for (std::size_t v = variables().size(); v > 0;) {
    const int level = variables()[v - 1].level;
    double a_squared = 0;
    double b_squared = 0;
    for (; v > 0 && variables()[v - 1].level == level; --v) {
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
