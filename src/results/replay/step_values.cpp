#include "src/results/replay/step_values.hpp"

#include <Eigen/QR>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"
#include "src/motion/robot/trapezoid.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::replay {

namespace {

/// m or degrees: values nearer to each other are the same.
constexpr double kSame = 1e-7;
constexpr int kNewtonRounds = 8;

using math::at;

class StepSolver {
 public:
  StepSolver(const Machine& machine, const RecordedStep& step)
      : machine_(machine), step_(step), steps_(step.before.size(), 0.0) {}

  ReachedStep solve() {
    for (int round = 0; round < kNewtonRounds; ++round) {
      if (!improve()) break;
    }
    unwrap();
    std::vector<double> reached = apply(steps_);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const double off = difference(i, reached[i]);
      if (!(std::fabs(off) <= kSame)) reached[i] += std::isfinite(off) ? off : 0;
    }
    return {std::move(reached), std::move(steps_)};
  }

 private:
  const robot::Parameter& parameter(int index) const {
    return machine_.model.parameters[at(index)];
  }

  std::vector<double> apply(const std::vector<double>& steps) const {
    std::vector<double> reached(step_.before.begin(), step_.before.end());
    robot::apply_rules(machine_.model, machine_.mounting, step_.before, steps, reached);
    return reached;
  }

  /// What is missing to the recorded value; of an angle that turns freely without whole turns.
  double difference(std::size_t i, double reached) const {
    return robot::reduced(machine_.model.parameters[i], step_.after[i] - reached);
  }

  /// One round of Newton's method; false when there is nothing left to improve.
  bool improve() {
    const std::vector<double> here = apply(steps_);
    Eigen::VectorXd off(static_cast<Eigen::Index>(here.size()));
    for (std::size_t i = 0; i < here.size(); ++i) {
      off[static_cast<Eigen::Index>(i)] = difference(i, here[i]);
    }
    if (!off.allFinite() || off.cwiseAbs().maxCoeff() <= kSame / 100) return false;
    const auto count = static_cast<Eigen::Index>(step_.moved.size());
    Eigen::MatrixXd change(off.size(), count);
    for (Eigen::Index j = 0; j < count; ++j) {
      const int moved = step_.moved[static_cast<std::size_t>(j)];
      const double h = parameter(moved).step > 0 ? parameter(moved).step : 1;
      std::vector<double> steps = steps_;
      steps[at(moved)] += h;
      const std::vector<double> there = apply(steps);
      for (std::size_t i = 0; i < there.size(); ++i) {
        change(static_cast<Eigen::Index>(i), j) = (there[i] - here[i]) / h;
      }
    }
    if (!change.allFinite()) return false;
    const Eigen::VectorXd more = change.colPivHouseholderQr().solve(off);
    for (Eigen::Index j = 0; j < count; ++j) {
      steps_[at(step_.moved[static_cast<std::size_t>(j)])] += more[j];
    }
    return true;
  }

  double speed(int moved) const {
    return step_.loaded ? parameter(moved).loaded_speed : parameter(moved).speed;
  }

  /// Seconds of a step of one parameter, from where it is in its run.
  double seconds(int moved, double ds) const {
    const double acceleration = parameter(moved).acceleration;
    if (!(acceleration > 0)) return std::fabs(ds) / speed(moved);
    const double gone = step_.gone.empty() ? 0 : step_.gone[at(moved)];
    const double from = gone * ds > 0 ? std::fabs(gone) : 0;
    return robot::time_under_way(from + std::fabs(ds), speed(moved), acceleration) -
           robot::time_under_way(from, speed(moved), acceleration);
  }

  /// A step of more than half a turn looks like one the other way round; its duration tells.
  void unwrap() {
    for (const int moved : step_.moved) {
      const robot::Parameter& p = parameter(moved);
      if (!p.cyclic || !(p.step > math::kHalfTurn_deg) || !(speed(moved) > 0)) continue;
      const double step = steps_[at(moved)];
      const double other = math::other_way_round_deg(step);
      const auto off = [&](double ds) {
        const double duration = seconds(moved, ds) * interpreter::kTicksPerSecond;
        return std::fabs(std::floor(duration + 0.5) - static_cast<double>(step_.duration));
      };
      if (std::fabs(other) <= p.step && off(other) < off(step)) steps_[at(moved)] = other;
    }
  }

  const Machine& machine_;
  const RecordedStep& step_;
  std::vector<double> steps_;
};

}  // namespace

ReachedStep reached_values(const Machine& machine, const RecordedStep& step) {
  return StepSolver(machine, step).solve();
}

}  // namespace rubicon::replay
