#include "src/robot/tip_first_step.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <optional>

namespace rubicon::robot {
namespace {

/// Singular values (m or rad per rad) below this part of the largest, or of 1, are taken for 0: a
/// direction in which the tool hardly moves is left to later wishes.
constexpr double kRank = 1e-6;

/// Metres or radians by which a step may pass a limit before the variable is held at it (it is
/// clamped in any case).
constexpr double kLimitSlack = 1e-13;

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

}  // namespace

std::vector<double> tip_first_step(const GoalProblem& problem, const GoalState& state,
                                   std::size_t count) {
  const PoseJacobian jacobian = problem.jacobian(state, count);
  std::vector<bool> held(count, false);
  std::vector<double> step(count, 0.0);
  for (std::size_t round = 0; round <= count; ++round) {
    free_step(problem, state, jacobian, held, step);
    // The innermost level gives way first: what it cannot do is left to its parents.
    std::optional<std::size_t> worst;
    double worst_passed = kLimitSlack;
    double worst_step = 0;
    for (std::size_t v = 0; v < count; ++v) {
      if (held[v]) continue;
      const GoalVariable& variable = problem.variables()[v];
      if (worst && variable.level > problem.variables()[*worst].level) break;
      const Parameter& parameter = problem.parameter(v);
      const double up = (parameter.upper - state.q[variable.parameter]) / variable.scale;
      const double down = (parameter.lower - state.q[variable.parameter]) / variable.scale;
      const double passed = std::max(step[v] - up, down - step[v]);
      if (!(passed > worst_passed)) continue;
      worst = v;
      worst_passed = passed;
      worst_step = step[v] > up ? up : down;
    }
    if (!worst) break;
    held[*worst] = true;
    step[*worst] = worst_step;
  }
  return step;
}

}  // namespace rubicon::robot
