#pragma once

#include <optional>
#include <span>
#include <vector>

#include "src/motion/robot/goal_clauses.hpp"
#include "src/motion/robot/robot_model.hpp"

namespace rubicon::robot {

using math::Pose;
using math::Vec3;

/// A robot where it stands: its mounting frame in the world and its start values p_c (the plan may
/// override them).
struct Mounting {
  Pose X_WM = Pose::Identity();
  std::vector<double> starts;  ///< per parameter; what p_c means in rules and frames
};

/// The configuration at s in [0, 1] of a step from q0 to q1, along which the control parameters run
/// linearly; exactly q0 and q1 at the ends.
std::vector<double> configuration_at(std::span<const double> q0, std::span<const double> q1,
                                     double s);

/// Poses X_WB of all bodies at configuration q (file units).
void body_poses(const RobotModel& model, const Mounting& mounting, std::span<const double> q,
                std::vector<Pose>& X_WB);

/// Pose X_WT of the tool frame at configuration q.
Pose tool_pose(const RobotModel& model, const Mounting& mounting, std::span<const double> q);

/// q after the steps `steps` (p_s, one per parameter): all rules with the old values, assigned at
/// once, then derived parameters. Cyclic angles are not normalised (so that the sweep is
/// unwrapped); see `normalise` in turns.hpp.
void apply_rules(const RobotModel& model, const Mounting& mounting, std::span<const double> q,
                 std::span<const double> steps, std::span<double> q_next);

/// Evaluates the derived parameters of q in place.
void update_derived(const RobotModel& model, const Mounting& mounting, std::span<double> q);

/// LANGUAGE 6.2: the value parameter p would have to take, all others left alone, to be as near to
/// the goal position p_WG as possible (translation) or to face it (rotation). Cyclic results are in
/// (-180, 180]; of a limited rotation the turn-equivalent inside the range nearest to q(p) is used.
double relative_goal(const RobotModel& model, const Mounting& mounting, std::span<const double> q,
                     int parameter, const Vec3& p_WG);

/// How near a goal frame must be met.
struct PoseTolerance {
  double position = 1e-6;     ///< m
  double orientation = 1e-6;  ///< rad
};

struct GoalSolution {
  bool reachable = false;
  std::vector<double> q;
  double position_error = 0;     ///< m, of the nearest configuration found
  double orientation_error = 0;  ///< rad
};

/// LANGUAGE 6.1: the configuration that brings the tool frame to X_WG, tip first: the tool body's
/// own parameters come as near as they can within their ranges; a parent's are added only for what
/// remains and move as little as that needs. Closed forms for vehicles, cranes and
/// the arms of excavators (closed_form_goal.hpp), damped least squares with clamping otherwise, and
/// where a turn is free or, but for arms, something is locked. Solved to 1e-9 m and rad where it
/// can be; reachable within `tolerance`. Clauses: locked parameters stay at q_now; the search, and
/// what is near, begins at q_now with the values of `near`.
GoalSolution solve_goal(const RobotModel& model, const Mounting& mounting,
                        std::span<const double> q_now, const Pose& X_WG,
                        const PoseTolerance& tolerance, const GoalClauses& clauses = {});

}  // namespace rubicon::robot
