#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "src/motion/math/turns.hpp"
#include "src/motion/robot/closed_form_goal.hpp"
#include "src/motion/robot/damped_least_squares.hpp"
#include "src/motion/robot/goal_problem.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/motion/robot/tip_first_step.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::robot {
namespace {

/// Iterations that move a solution along what the goal leaves free, and the least part of a step
/// that is tried.
constexpr int kMostRefinements = 60;
constexpr double kLeastPart = 1.0 / 128;

/// Levels of more variables than this are not refined: the work grows with their cube, and no
/// machine has them.
constexpr std::size_t kMostRefined = 40;

/// Points spread over the ranges that are tried as starts where the obvious ones lead nowhere: so
/// many where few poses can be met at all, and so many by all parameters of a robot that has as
/// many as the goal asks for, or one less: of 30 starts of an arm with five joints four led to its
/// goal.
constexpr int kSpreadStarts = 10;
constexpr int kMostSpreadStarts = 200;

/// So many with the values that `near` names, where the goal can be met: a wrist has several ways.
constexpr int kNamedStarts = 40;

/// Unlimited translations are spread over this distance (m) about their value now.
constexpr double kSpread = 10;

/// Element `index` of the van der Corput sequence in the given base, in (0, 1): evenly spread, the
/// same every time.
double van_der_corput(int index, int base) {
  double value = 0;
  double part = 1.0 / base;
  for (; index > 0; index /= base, part /= base) value += (index % base) * part;
  return value;
}

class GoalSearch {
 public:
  explicit GoalSearch(const GoalProblem& problem) : problem_(problem) {}

  /// Tip first: the variables of the tool's body alone, then with its parent's, and so on, until
  /// the goal is met.
  GoalState run() const {
    const auto& variables = problem_.variables();
    GoalState best = problem_.at(clamped(problem_.q_now()));
    for (std::size_t count = 0;
         count < variables.size() && !problem_.solved(best) && !problem_.exhausted();) {
      const int level = variables[count].level;
      while (count < variables.size() && variables[count].level == level) ++count;
      const GoalState start = best;
      for (GoalState& other : starts(start, count)) improve(best, std::move(other), count);
      const bool can_meet = count == variables.size() && count + 1 >= problem_.numbers_asked();
      const int spread_starts = can_meet ? kMostSpreadStarts : kSpreadStarts;
      for (int i = 1; i <= spread_starts && !problem_.solved(best) && !problem_.exhausted(); ++i) {
        improve(best, problem_.at(spread(start, count, i)), count);
      }
      if (problem_.chain().has_named() && problem_.solved(best)) {
        for (GoalState& other : named_starts(start, count)) improve(best, std::move(other), count);
      }
      best = refined(std::move(best), count);
    }
    return best;
  }

 private:
  std::vector<double> clamped(std::vector<double> q) const {
    for (const GoalVariable& variable : problem_.variables()) {
      const Parameter& parameter = problem_.model().parameters[variable.parameter];
      q[variable.parameter] = std::clamp(q[variable.parameter], parameter.lower, parameter.upper);
    }
    return q;
  }

  /// The best so far, with rotations turned to the goal, and the same from the middle of the
  /// ranges.
  std::vector<GoalState> starts(const GoalState& best, std::size_t count) const {
    std::vector<double> middle = best.q;
    for (std::size_t v = 0; v < count; ++v) {
      const Parameter& p = problem_.parameter(v);
      const double centre = p.lower / 2 + p.upper / 2;
      if (std::isfinite(centre)) middle[problem_.variables()[v].parameter] = centre;
    }
    return {best, problem_.at(facing(best.q, count)), problem_.at(middle),
            problem_.at(facing(middle, count))};
  }

  /// With the values that `near` names: what the other variables make of the goal while these are
  /// held, from where they are and from points spread over their ranges.
  std::vector<GoalState> named_starts(const GoalState& best, std::size_t count) const {
    GoalClauses clauses = problem_.chain().clauses();
    std::vector<double> named = best.q;
    for (std::size_t v = 0; v < problem_.variables().size(); ++v) {
      const GoalVariable& variable = problem_.variables()[v];
      if (variable.named) named[variable.parameter] = problem_.q_now()[variable.parameter];
      if (variable.named || v >= count) {
        clauses.locked.push_back(static_cast<int>(variable.parameter));
      }
    }
    std::sort(clauses.locked.begin(), clauses.locked.end());
    named = clamped(std::move(named));
    const GoalChain others(problem_.model(), std::move(clauses));
    const GoalProblem rest(others, problem_.mounting(), named, problem_.goal());
    std::vector<GoalState> starts;
    for (int i = 0; i <= kNamedStarts; ++i) {
      std::vector<double> q = i == 0 ? named : spread(best, count, i);
      for (std::size_t v = 0; v < count; ++v) {
        const GoalVariable& variable = problem_.variables()[v];
        if (variable.named) q[variable.parameter] = named[variable.parameter];
      }
      const GoalState met = damped_least_squares(rest, rest.at(std::move(q)),
                                                 others.variables().size(), GoalPart::pose);
      starts.push_back(problem_.at(met.q));
    }
    return starts;
  }

  /// q with the rotations set to their r_goal one after the other, base first.
  std::vector<double> facing(std::vector<double> q, std::size_t count) const {
    for (std::size_t v = count; v-- > 0;) {
      if (!problem_.parameter(v).rotation) continue;
      const std::size_t i = problem_.variables()[v].parameter;
      q[i] = relative_goal(problem_.model(), problem_.mounting(), q, static_cast<int>(i),
                           problem_.goal().translation());
      q = problem_.at(clamped(std::move(q))).q;
    }
    return q;
  }

  std::vector<double> spread(const GoalState& best, std::size_t count, int index) const {
    static constexpr int kPrimes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
    std::vector<double> q = best.q;
    for (std::size_t v = 0; v < count; ++v) {
      const Parameter& p = problem_.parameter(v);
      double& value = q[problem_.variables()[v].parameter];
      const double half = p.rotation ? 180 : kSpread;
      const double lower = std::isfinite(p.lower) ? p.lower : value - half;
      const double upper = std::isfinite(p.upper) ? p.upper : value + half;
      value = lower + van_der_corput(index, kPrimes[v % std::size(kPrimes)]) * (upper - lower);
    }
    return clamped(std::move(q));
  }

  /// Replaces `best` by what is found from a start, if that is better: the whole frame where it can
  /// be met, else the position before the orientation.
  void improve(GoalState& best, GoalState start, std::size_t count) const {
    GoalState found = nearest_turns(
        damped_least_squares(problem_, std::move(start), count, GoalPart::pose), count);
    if (problem_.solved(found)) {
      found = refined(std::move(found), count);
    } else {
      GoalState at_position =
          nearest_turns(damped_least_squares(problem_, found, count, GoalPart::position), count);
      if (problem_.better(at_position, found)) found = std::move(at_position);
    }
    if (problem_.better(found, best)) best = std::move(found);
  }

  /// Turn-equivalent angles nearest to those now, where the frames do not mind.
  GoalState nearest_turns(GoalState state, std::size_t count) const {
    for (std::size_t v = 0; v < count; ++v) {
      const Parameter& p = problem_.parameter(v);
      if (!p.rotation) continue;
      const std::size_t i = problem_.variables()[v].parameter;
      const double now = problem_.q_now()[i];
      std::vector<double> q = state.q;
      q[i] = p.limited() ? nearest_turn_equivalent(p, q[i], now)
                         : math::nearest_equivalent_deg(q[i], now);
      if (q[i] == state.q[i]) continue;
      GoalState turned = problem_.at(std::move(q));
      const bool same = turned.position_error <= state.position_error + kSolved &&
                        turned.orientation_error <= state.orientation_error + kSolved;
      if (same) state = std::move(turned);
    }
    return state;
  }

  /// Follows tip_first_step along the configurations that meet the goal as well as `best` does, as
  /// long as it gets better; every step is brought back onto them by least squares.
  GoalState refined(GoalState best, std::size_t count) const {
    if (count > kMostRefined) return best;
    double part = 1;
    for (int i = 0; i < kMostRefinements && part >= kLeastPart && !problem_.exhausted(); ++i) {
      const std::vector<double> step = tip_first_step(problem_, best, count);
      std::vector<double> q = best.q;
      double size = 0;
      for (std::size_t v = 0; v < count; ++v) {
        const GoalVariable& variable = problem_.variables()[v];
        q[variable.parameter] += part * step[v] * variable.scale;
        size = std::max(size, std::fabs(part * step[v]));
      }
      if (!(size > 0)) break;
      const GoalState next = problem_.at(clamped(std::move(q)));
      // As it is where the robot is linear; else led back, by all of the frame where it can be met.
      const GoalState* chosen = problem_.better(next, best) ? &next : nullptr;
      const GoalState by_frame = damped_least_squares(problem_, next, count, GoalPart::pose);
      if (problem_.better(by_frame, chosen ? *chosen : best)) chosen = &by_frame;
      const GoalState by_position = damped_least_squares(problem_, next, count, GoalPart::position);
      if (problem_.better(by_position, chosen ? *chosen : best)) chosen = &by_position;
      if (chosen) {
        best = *chosen;
        part = std::min(1.0, 2 * part);
      } else {
        part /= 2;
      }
    }
    return best;
  }

  const GoalProblem& problem_;
};

bool finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(),
                     [](double value) { return std::isfinite(value); });
}

/// m: a robot that stands farther from the origin is solved as if it stood there. Of a redundant
/// arm at 9 km, rounding chose another posture.
constexpr double kFarFromOrigin = 1000;

}  // namespace

GoalState search_goal(const GoalProblem& problem) { return GoalSearch(problem).run(); }

GoalSolution solve_goal(const RobotModel& model, const Mounting& mounting,
                        std::span<const double> q_now, const Pose& X_WG,
                        const PoseTolerance& tolerance, const GoalClauses& clauses) {
  GoalSolution solution;
  solution.q.assign(q_now.begin(), q_now.end());
  for (const auto& [index, value] : clauses.near) {
    const auto i = static_cast<std::size_t>(index);
    if (!clauses.locks(index)) {
      solution.q[i] = nearest_turn_equivalent(model.parameters[i], value, q_now[i]);
    }
  }
  if (!finite(q_now) || !X_WG.matrix().allFinite()) {
    solution.position_error = solution.orientation_error = std::numeric_limits<double>::infinity();
    return solution;
  }
  Pose X_NG = X_WG;
  std::optional<Mounting> near;
  if (mounting.X_WM.translation().norm() > kFarFromOrigin) {
    near = mounting;
    near->X_WM.translation().setZero();
    X_NG.translation() -= mounting.X_WM.translation();
  }
  const GoalChain chain(model, clauses);
  const GoalProblem problem(chain, near ? *near : mounting, solution.q, X_NG);
  const bool plain = clauses.free == FreeTurn::none;
  GoalState state = problem.at(solution.q);
  if (!problem.solved(state)) {
    if (auto known = plain ? closed_form_goal(problem) : std::nullopt) {
      state = std::move(*known);
    } else {
      state = search_goal(problem);
    }
  }
  solution.q = std::move(state.q);
  normalise(model, solution.q);
  if (!finite(solution.q))
    return {false, {q_now.begin(), q_now.end()}, state.position_error, state.orientation_error};
  solution.position_error = state.position_error;
  solution.orientation_error = state.orientation_error;
  solution.reachable = state.position_error <= std::max(tolerance.position, kSolved) &&
                       state.orientation_error <= std::max(tolerance.orientation, kSolved);
  return solution;
}

}  // namespace rubicon::robot
