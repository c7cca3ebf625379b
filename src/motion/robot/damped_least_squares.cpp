#include "src/motion/robot/damped_least_squares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rubicon::robot {
namespace {

constexpr int kMostIterations = 150;

/// Rounds of holding variables at their limits within one step.
constexpr int kMostHoldRounds = 12;

/// Largest turn of one joint in one iteration, radians: beyond it the linear model says nothing.
constexpr double kMostTurn = 0.7;

/// Damping (m^2) to start with and at most; it falls and rises with success as Levenberg proposed.
constexpr double kFirstDamping = 1e-3;
constexpr double kMostDamping = 1e9;

/// Least damping as a part of the squared Jacobian: less would turn rounding into motion where the
/// goal is out of reach.
constexpr double kLeastDampingPart = 1e-10;

/// Part of the squared error by which an iteration has to lower it where the goal is out of reach;
/// what is still to be had is then below a few parts in a thousand million.
constexpr double kLeastGain = 1e-10;

/// Squared error (m^2 + rad^2) that is nothing but rounding, and the step (m, rad) that is.
constexpr double kRoundingSquared = 1e-29;
constexpr double kRoundingStep = 1e-15;

using Square = Eigen::Matrix<double, 6, 6>;

/// Solves the symmetric positive definite system A x = b (Cholesky). A is damped, so its pivots are
/// positive.
PoseResidual solve(Square A, PoseResidual b) {
  for (int k = 0; k < 6; ++k) {
    A(k, k) = std::sqrt(std::max(A(k, k), 1e-300));
    for (int i = k + 1; i < 6; ++i) A(i, k) /= A(k, k);
    for (int j = k + 1; j < 6; ++j) {
      for (int i = j; i < 6; ++i) A(i, j) -= A(i, k) * A(j, k);
    }
  }
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < i; ++k) b[i] -= A(i, k) * b[k];
    b[i] /= A(i, i);
  }
  for (int i = 5; i >= 0; --i) {
    for (int k = i + 1; k < 6; ++k) b[i] -= A(k, i) * b[k];
    b[i] /= A(i, i);
  }
  return b;
}

PoseResidual counted(PoseResidual residual, GoalPart part) {
  if (part == GoalPart::position) residual.tail<3>().setZero();
  return residual;
}

/// The damped step of all variables (m, rad), inside the ranges.
std::vector<double> step_inside(const GoalProblem& problem, const GoalState& state,
                                const PoseJacobian& jacobian, const PoseResidual& residual,
                                double damping) {
  const auto count = static_cast<std::size_t>(jacobian.cols());
  std::vector<double> step(count, 0.0);
  std::vector<bool> held(count, false);
  for (int round = 0; round < kMostHoldRounds; ++round) {
    Square A = Square::Identity() * damping;
    PoseResidual rest = residual;
    for (std::size_t v = 0; v < count; ++v) {
      const PoseResidual column = jacobian.col(static_cast<Eigen::Index>(v));
      if (held[v]) {
        rest -= column * step[v];
      } else {
        A += column * column.transpose();
      }
    }
    const PoseResidual multiplier = solve(A, rest);
    bool inside = true;
    for (std::size_t v = 0; v < count; ++v) {
      if (held[v]) continue;
      const Parameter& parameter = problem.parameter(v);
      const GoalVariable& variable = problem.variables()[v];
      const double value = state.q[variable.parameter];
      step[v] = jacobian.col(static_cast<Eigen::Index>(v)).dot(multiplier);
      const double wanted = value + step[v] * variable.scale;
      const double allowed = std::clamp(wanted, parameter.lower, parameter.upper);
      if (allowed == wanted) continue;
      step[v] = (allowed - value) / variable.scale;
      held[v] = true;
      inside = false;
    }
    if (inside) break;
  }
  return step;
}

std::vector<double> moved_by(const GoalProblem& problem, const GoalState& state,
                             const std::vector<double>& step, double part) {
  std::vector<double> q = state.q;
  for (std::size_t v = 0; v < step.size(); ++v) {
    const GoalVariable& variable = problem.variables()[v];
    const Parameter& parameter = problem.parameter(v);
    double& value = q[variable.parameter];
    value = std::clamp(value + part * step[v] * variable.scale, parameter.lower, parameter.upper);
  }
  return q;
}

/// Part of the step at which the fastest joint turns by kMostTurn, at most 1.
double allowed_part(const GoalProblem& problem, const std::vector<double>& step) {
  double fastest = 0;
  for (std::size_t v = 0; v < step.size(); ++v) {
    if (problem.parameter(v).rotation) fastest = std::max(fastest, std::fabs(step[v]));
  }
  return fastest > kMostTurn ? kMostTurn / fastest : 1;
}

double largest(const std::vector<double>& step) {
  double most = 0;
  for (const double s : step) most = std::max(most, std::fabs(s));
  return most;
}

}  // namespace

GoalState damped_least_squares(const GoalProblem& problem, GoalState start, std::size_t count,
                               GoalPart part) {
  GoalState state = std::move(start);
  if (count == 0) return state;
  double damping = kFirstDamping;
  bool fresh = true;
  PoseJacobian jacobian;
  PoseResidual residual = counted(state.residual, part);
  for (int i = 0; i < kMostIterations && !problem.exhausted(); ++i) {
    if (residual.squaredNorm() <= kRoundingSquared) break;
    if (fresh) {
      jacobian = problem.jacobian(state, count);
      if (part == GoalPart::position) jacobian.bottomRows<3>().setZero();
    }
    damping = std::max(damping, kLeastDampingPart * jacobian.squaredNorm());
    const std::vector<double> step = step_inside(problem, state, jacobian, residual, damping);
    const double size = largest(step);
    if (!(size > kRoundingStep)) break;
    GoalState next = problem.at(moved_by(problem, state, step, allowed_part(problem, step)));
    const PoseResidual next_residual = counted(next.residual, part);
    fresh = next_residual.squaredNorm() < residual.squaredNorm();
    if (fresh) {
      const double before = residual.squaredNorm();
      state = std::move(next);
      residual = next_residual;
      if (before > kSolved * kSolved && before - residual.squaredNorm() < kLeastGain * before)
        break;
      damping /= 10;
    } else {
      if (size < 1e-12 || damping > kMostDamping) break;
      damping *= 8;
    }
  }
  return state;
}

}  // namespace rubicon::robot
