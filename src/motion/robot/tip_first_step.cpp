#include "src/motion/robot/tip_first_step.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>

namespace rubicon::robot {
namespace {

/// Singular values (m or rad per rad) below this part of the largest, or of 1, are taken for 0: a
/// direction in which the tool hardly moves is left to later wishes.
constexpr double kRank = 1e-6;

/// Metres or radians that count as no change of a step, and as standing on a limit.
constexpr double kNoChange = 1e-12;

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// A step that fulfils the wishes so far, and an orthonormal basis of the steps that do not disturb
/// them.
struct PriorityStep {
  Vector step;
  Matrix basis;

  explicit PriorityStep(Eigen::Index size)
      : step(Vector::Zero(size)), basis(Matrix::Identity(size, size)) {}

  /// Fulfils A step = b by least squares as far as the basis allows.
  void fulfil(const Matrix& A, const Vector& b) {
    if (basis.cols() == 0 || A.rows() == 0) return;
    const Matrix restricted = A * basis;
    const Eigen::JacobiSVD<Matrix> svd(restricted, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Vector& values = svd.singularValues();
    const double least = kRank * std::max(1.0, values.size() > 0 ? values[0] : 0.0);
    Eigen::Index rank = 0;
    while (rank < values.size() && values[rank] > least) ++rank;
    const Vector missing = svd.matrixU().transpose() * (b - A * step);
    Vector along = Vector::Zero(basis.cols());
    for (Eigen::Index i = 0; i < rank; ++i)
      along += svd.matrixV().col(i) * (missing[i] / values[i]);
    step += basis * along;
    basis = (basis * svd.matrixV().rightCols(basis.cols() - rank)).eval();
  }
};

/// The step of the variables that are not held; held ones keep their entry.
void free_step(const GoalProblem& problem, const GoalState& state, const PoseJacobian& jacobian,
               const std::vector<bool>& held, std::vector<double>& step) {
  std::vector<std::size_t> loose;
  PoseResidual rest = state.residual;
  for (std::size_t v = 0; v < held.size(); ++v) {
    if (held[v]) {
      rest -= jacobian.col(static_cast<Eigen::Index>(v)) * step[v];
    } else {
      loose.push_back(v);
    }
  }
  if (loose.empty()) return;
  const auto size = static_cast<Eigen::Index>(loose.size());
  Matrix columns(6, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    columns.col(i) = jacobian.col(static_cast<Eigen::Index>(loose[static_cast<std::size_t>(i)]));
  }
  PriorityStep priority(size);
  priority.fulfil(columns.topRows(3), rest.head<3>());
  priority.fulfil(columns.bottomRows(3), rest.tail<3>());
  // Variables are ordered by level, tip first: the base-most level is the last run.
  for (Eigen::Index last = size; last > 0;) {
    const auto level_of = [&](Eigen::Index i) {
      return problem.variables()[loose[static_cast<std::size_t>(i)]].level;
    };
    Eigen::Index first = last - 1;
    while (first > 0 && level_of(first - 1) == level_of(last - 1)) --first;
    Matrix chosen = Matrix::Zero(last - first, size);
    Vector back(last - first);
    for (Eigen::Index i = first; i < last; ++i) {
      chosen(i - first, i) = 1;
      back[i - first] = -problem.moved(state, loose[static_cast<std::size_t>(i)]);
    }
    priority.fulfil(chosen, back);
    last = first;
  }
  for (Eigen::Index i = 0; i < size; ++i)
    step[loose[static_cast<std::size_t>(i)]] = priority.step[i];
}

/// The box of allowed steps.
struct StepLimits {
  std::vector<double> lower, upper;
};

StepLimits step_limits(const GoalProblem& problem, const GoalState& state, std::size_t count) {
  StepLimits limits;
  for (std::size_t v = 0; v < count; ++v) {
    const GoalVariable& variable = problem.variables()[v];
    const double value = state.q[variable.parameter];
    limits.lower.push_back(std::min(0.0, (problem.parameter(v).lower - value) / variable.scale));
    limits.upper.push_back(std::max(0.0, (problem.parameter(v).upper - value) / variable.scale));
  }
  return limits;
}

/// Moves `step` towards `target` up to the first limit in the way and holds the variable that meets
/// it; true if it moved or a variable was held.
bool advance(const std::vector<double>& target, const StepLimits& limits, std::vector<double>& step,
             std::vector<bool>& held) {
  double part = 1;
  std::optional<std::size_t> blocking;
  double change = 0;
  for (std::size_t v = 0; v < step.size(); ++v) {
    if (held[v]) continue;
    const double wanted = target[v] - step[v];
    change = std::max(change, std::fabs(wanted));
    const double limit = wanted > 0 ? limits.upper[v] : limits.lower[v];
    if (wanted == 0 || (wanted > 0 ? target[v] <= limit : target[v] >= limit)) continue;
    const double reach = std::max(0.0, (limit - step[v]) / wanted);
    if (reach >= part) continue;
    part = reach;
    blocking = v;
  }
  if (change <= kNoChange) return false;
  for (std::size_t v = 0; v < step.size(); ++v) {
    if (!held[v])
      step[v] =
          std::clamp(step[v] + part * (target[v] - step[v]), limits.lower[v], limits.upper[v]);
  }
  if (blocking) {
    step[*blocking] =
        target[*blocking] > step[*blocking] ? limits.upper[*blocking] : limits.lower[*blocking];
    held[*blocking] = true;
  }
  return true;
}

}  // namespace

std::vector<double> tip_first_step(const GoalProblem& problem, const GoalState& state,
                                   std::size_t count) {
  const PoseJacobian jacobian = problem.jacobian(state, count);
  const StepLimits limits = step_limits(problem, state, count);
  std::vector<bool> held(count, false);
  std::vector<double> step(count, 0.0);
  for (std::size_t v = 0; v < count; ++v)
    held[v] = limits.upper[v] <= kNoChange || limits.lower[v] >= -kNoChange;

  // Primal active set: go to the best step with some variables held; when there, let go of one that
  // then moves inwards. Every round is at least as good as the one before; the bound on rounds is
  // for degenerate corners.
  const std::size_t most_rounds = 8 * count + 8;
  for (std::size_t round = 0; round < most_rounds; ++round) {
    std::vector<double> target = step;
    free_step(problem, state, jacobian, held, target);
    if (advance(target, limits, step, held)) continue;
    bool released = false;
    for (std::size_t v = 0; v < count && !released; ++v) {
      if (!held[v]) continue;
      held[v] = false;
      target = step;
      free_step(problem, state, jacobian, held, target);
      const bool upwards = target[v] > step[v] + kNoChange && step[v] < limits.upper[v] - kNoChange;
      const bool downwards =
          target[v] < step[v] - kNoChange && step[v] > limits.lower[v] + kNoChange;
      released = upwards || downwards;
      if (!released) held[v] = true;
    }
    if (!released) break;
  }
  return step;
}

}  // namespace rubicon::robot
