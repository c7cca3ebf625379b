#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "src/motion/robot/kinematics.hpp"

namespace rubicon::robot {

/// Metres and radians within which a goal frame counts as met by the solver (LANGUAGE, "Settled on
/// top"). Also the least difference of two errors or moves that counts when configurations are
/// compared.
inline constexpr double kSolved = 1e-9;

/// Rows 0-2: metres (world); rows 3-5: radians, rotation vector (world).
using PoseResidual = Eigen::Matrix<double, 6, 1>;
/// Columns per metre or radian of a variable.
using PoseJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// A control parameter the solver may move.
struct GoalVariable {
  std::size_t parameter = 0;
  int level = 0;       ///< 0: of the tool's body or what drives it, 1: of its parent, ...
  double scale = 1;    ///< file units per metre or radian
  bool named = false;  ///< `near` names it
};

/// A configuration with what is left to the goal.
struct GoalState {
  std::vector<double> q;
  PoseResidual residual = PoseResidual::Zero();  ///< goal - tool
  double position_error = 0;                     ///< m
  double orientation_error = 0;                  ///< rad
};

/// What a robot may move for a goal: the free parameters between tool and base that are not locked,
/// tip first; also those of other bodies that they are derived from. The robot must outlive it.
class GoalChain {
 public:
  explicit GoalChain(const RobotModel& model, GoalClauses clauses = {});

  const RobotModel& model() const { return model_; }
  const GoalClauses& clauses() const { return clauses_; }
  const std::vector<const FrameElement*>& elements() const { return elements_; }
  /// Ordered by level.
  const std::vector<GoalVariable>& variables() const { return variables_; }
  bool has_derived() const { return has_derived_; }
  /// Whether `near` names any of the variables.
  bool has_named() const {
    return std::any_of(variables_.begin(), variables_.end(),
                       [](const GoalVariable& each) { return each.named; });
  }
  /// How many parameters a robot needs to meet any goal in reach: 6, less what may turn freely.
  std::size_t numbers_asked() const {
    return clauses_.free == FreeTurn::none ? 6 : clauses_.free == FreeTurn::all ? 3 : 5;
  }

 private:
  const RobotModel& model_;
  GoalClauses clauses_;
  std::vector<const FrameElement*> elements_;
  std::vector<GoalVariable> variables_;
  bool has_derived_ = false;
};

/// The task "bring the tool frame to X_WG", as a function of the variables of a chain. Mounting and
/// chain must outlive it.
class GoalProblem {
 public:
  GoalProblem(const GoalChain& chain, const Mounting& mounting, std::span<const double> q_now,
              const Pose& X_WG)
      : chain_(chain), mounting_(mounting), q_now_(q_now.begin(), q_now.end()), X_WG_(X_WG) {}

  const RobotModel& model() const { return chain_.model(); }
  const Mounting& mounting() const { return mounting_; }
  const Pose& goal() const { return X_WG_; }
  const std::vector<double>& q_now() const { return q_now_; }
  const std::vector<const FrameElement*>& elements() const { return chain_.elements(); }
  /// Ordered by level.
  const std::vector<GoalVariable>& variables() const { return chain_.variables(); }
  const Parameter& parameter(std::size_t variable) const {
    return model().parameters[variables()[variable].parameter];
  }

  /// Tool pose and errors at q, after the derived parameters are brought up to date.
  GoalState at(std::vector<double> q) const;

  /// How the tool moves by each of the first `count` variables.
  PoseJacobian jacobian(const GoalState& state, std::size_t count) const;

  /// How far a variable is from its value now (m or rad, signed; a cyclic one the shorter way).
  double moved(const GoalState& state, std::size_t variable) const;

  /// Whether `a` is to be preferred to `b`: nearer in position, then in orientation, then to the
  /// values that `near` names (m and rad, squared), then the parents moved less, the base before
  /// all; differences below kSolved do not count.
  bool better(const GoalState& a, const GoalState& b) const;

  /// Whether the solver may change a parameter, as far as locks say.
  bool moves(int parameter) const {
    return model().parameters[static_cast<std::size_t>(parameter)].free &&
           !chain_.clauses().locks(parameter);
  }
  const GoalChain& chain() const { return chain_; }
  std::size_t numbers_asked() const { return chain_.numbers_asked(); }
  bool turns_freely() const { return chain_.clauses().free != FreeTurn::none; }
  bool locks_any() const { return !chain_.clauses().locked.empty(); }

  bool solved(const GoalState& state) const {
    return state.position_error <= kSolved && state.orientation_error <= kSolved;
  }

  /// Bounded work: true once the solver has used up what it may spend on one goal. Only
  /// descriptions with hundreds of joints come near it; they get the best found so far.
  bool exhausted() const { return work_ > kMostWork; }

 private:
  double from_named(const GoalState& state) const;

  static constexpr std::size_t kMostWork =
      30'000'000;  ///< derivatives of frame elements: about two seconds

  const GoalChain& chain_;
  const Mounting& mounting_;
  std::vector<double> q_now_;
  Pose X_WG_;
  mutable std::size_t work_ = 0;
};

}  // namespace rubicon::robot
