#include "src/motion/robot/tool_line.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/closed_form_goal.hpp"
#include "src/motion/robot/damped_least_squares.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::robot {
namespace {

/// m and rad by which the tool is at the end of its way. Above kSolved, with which steps are found.
constexpr double kThere = 1e-8;

/// The way by whose configuration the length of a step is foretold: m and rad.
constexpr double kProbe = 1e-3;

/// The shortest step but the last: m and rad. Where less is allowed the line cannot be gone.
constexpr double kShortest = 1e-6;

/// Parts of a step at whose ends the deviation is measured; between them it is bounded.
constexpr int kParts = 8;

/// m or rad of the tool for m or rad of a parameter that hardly moves it.
constexpr double kIdle = 1e-9;

/// Part of what a parameter does to the tool that others do not do; less is rounding.
constexpr double kNothingNew = 1e-6;

/// Configurations in which it is looked at what each parameter does.
constexpr int kSamples = 3;

/// m, degrees: so far beyond the range of a parameter it is looked whether a line goes on there.
constexpr double kBeyondRange = 1000;

/// Trials of shorter steps.
constexpr int kMostTrials = 60;

/// Rounding of a step beside the longest that a parameter makes.
constexpr double kStepSlack = 1e-9;

using math::at;

/// A value within the range of a parameter that is like any: spread by the golden ratio. Without
/// limits within a quarter turn, or 10 m, of 0.
double sample_of(const Parameter& p, int index, std::size_t number) {
  constexpr double kGolden = 0.6180339887498949;
  double whole = 0;
  const double part = std::modf(kGolden * (index + kSamples * static_cast<double>(number)), &whole);
  const double half = p.rotation ? 90 : 10;
  const double lower = std::isfinite(p.lower) ? p.lower : std::min(-half, p.upper - 2 * half);
  const double upper = std::isfinite(p.upper) ? p.upper : std::max(half, lower + 2 * half);
  return lower + (0.05 + 0.9 * part) * (upper - lower);
}

}  // namespace

/// The straight way between two poses of the tool.
class ToolLine::Way {
 public:
  /// `shift`: the most that a parameter which is to end at a value is from it: m, rad.
  Way(const Pose& X_from, const Pose& X_to, FreeTurn free, double shift)
      : X_from_(X_from),
        free_(free),
        along_(X_to.translation() - X_from.translation()),
        turn_(turn_to_goal(X_from.linear(), X_to.linear(), free)),
        length_(along_.norm()),
        angle_(turn_.norm()),
        shift_(shift) {}

  bool is_over() const { return std::max({length_, angle_, shift_}) <= kThere; }
  /// The part of it that is so long (m, or rad where that is more).
  double part(double way) const { return std::min(1.0, way / std::max({length_, angle_, shift_})); }

  Pose at(double part) const {
    Pose X = X_from_;
    X.translation() += part * along_;
    X.linear() = rotation_by(part * turn_) * X_from_.linear();
    return X;
  }

  /// How far a pose is beside the first `part` of the way: m, rad.
  std::pair<double, double> off(const Pose& X, double part, double fraction) const {
    const Vec3 from = X.translation() - X_from_.translation();
    double gone = fraction * part;
    if (length_ > kThere) {
      gone = std::clamp(from.dot(along_) / (length_ * length_), 0.0, part);
    }
    const Vec3 turn = turn_to_goal(X.linear(), at(gone).linear(), free_);
    return {(from - gone * along_).norm(), turn.norm()};
  }

 private:
  Pose X_from_;
  FreeTurn free_;
  Vec3 along_;
  Vec3 turn_;
  double length_;
  double angle_;
  double shift_;
};

ToolLine::ToolLine(const RobotModel& model, const Mounting& mounting, LineDeviation deviation,
                   GoalClauses clauses)
    : model_(model), mounting_(mounting), deviation_(deviation), clauses_(std::move(clauses)) {
  clauses_.near.clear();
  std::vector<int> held;
  for (int i = 0; i < static_cast<int>(model.parameters.size()); ++i) {
    const Parameter& p = model.parameters[at(i)];
    const bool steps = p.step > 0 && p.direct && p.free && !p.derived;
    if (steps) stepped_.push_back(i);
    (steps && !clauses_.locks(i) ? moved_ : held).push_back(i);
  }
  clauses_.locked = held;
  chain_ = std::make_shared<const GoalChain>(model, clauses_);
  if (stepped_.empty()) refusal_ = "no parameter of it has a step or a speed of its own";
  for (int i = 1; i <= kSamples; ++i) {
    std::vector<double> q(model.parameters.size());
    for (std::size_t k = 0; k < q.size(); ++k) q[k] = sample_of(model.parameters[k], i, k);
    const GoalProblem problem(*chain_, mounting_, q, Pose::Identity());
    const PoseJacobian jacobian = problem.jacobian(problem.at(q), chain_->variables().size());
    if (!jacobian.allFinite()) continue;
    std::vector<std::array<double, 6>>& sample = samples_.emplace_back(chain_->variables().size());
    for (std::size_t v = 0; v < sample.size(); ++v) {
      Eigen::Map<PoseResidual>(sample[v].data()) = jacobian.col(static_cast<Eigen::Index>(v));
    }
  }
}

std::vector<double> ToolLine::change_between(std::span<const double> q,
                                             std::span<const double> q_to) const {
  std::vector<double> change(q.size(), 0.0);
  for (const int i : moved_) {
    change[at(i)] = robot::way_between(model_.parameters[at(i)], q[at(i)], q_to[at(i)]);
  }
  return change;
}

double ToolLine::share_allowed(std::span<const double> change) const {
  double share = 1;
  for (const int i : moved_) {
    const double length = std::fabs(change[at(i)]);
    const double step = model_.parameters[at(i)].step;
    if (length > step * (1 + kStepSlack)) share = std::min(share, step / length);
  }
  return share;
}

namespace {

/// How far the tool may be from where it is measured to be between two measured moments of a step:
/// a bound on its second derivative, by how far the joints on its way turn and shift in the step.
struct Bend {
  double position = 0;     ///< m
  double orientation = 0;  ///< rad
};

class StepMotion {
 public:
  StepMotion(const Mounting& mounting, const std::vector<const FrameElement*>& elements)
      : mounting_(mounting), elements_(elements) {}

  /// The pose of the tool at q, with what the joints have done since the pose before.
  Pose pose(std::span<const double> q) {
    const FormulaInput input = {q, {}, mounting_.starts};
    Pose X = mounting_.X_WM;
    values_now_.clear();
    joints_.clear();
    for (const FrameElement* element : elements_) {
      const bool shifts = element->kind == FrameElement::Kind::trans;
      values_now_.emplace_back(element->a.evaluate(input), shifts ? element->b.evaluate(input) : 0,
                               shifts ? element->c.evaluate(input) : 0);
      if (!shifts) joints_.emplace_back(X.translation());
      append(X, *element, input);
    }
    for (const Vec3& joint : joints_) {
      reach_ = std::max(reach_, (X.translation() - joint).norm());
    }
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double change = (values_now_[i] - values_[i]).norm();
      if (elements_[i]->kind == FrameElement::Kind::trans) {
        shift_ += change;
      } else {
        turn_ += math::radians(change);
      }
    }
    std::swap(values_, values_now_);
    return X;
  }

  Bend bend() const {
    const double reach = reach_ + shift_ + turn_ * reach_;
    constexpr double kChord = 1.0 / (8 * kParts * kParts);
    return {(turn_ * turn_ * reach + 2 * turn_ * shift_) * kChord, turn_ * turn_ * kChord};
  }

 private:
  const Mounting& mounting_;
  const std::vector<const FrameElement*>& elements_;
  std::vector<Vec3> values_, values_now_;
  std::vector<Vec3> joints_;
  double turn_ = 0;   ///< rad, of all joints
  double shift_ = 0;  ///< m
  double reach_ = 0;  ///< m, of the tool from the joints
};

}  // namespace

ToolLine::Way ToolLine::way_between(std::span<const double> q, std::span<const double> q_end,
                                    std::span<const int> named) const {
  double shift = 0;
  const auto count = [&](int i) {
    const Parameter& p = model_.parameters[at(i)];
    const double off = std::fabs(robot::way_between(p, q[at(i)], q_end[at(i)]));
    shift = std::max(shift, p.rotation ? math::radians(off) : off);
  };
  for (const int i : named) count(i);
  for (const int i : steered(named)) count(i);
  return {tool_pose(model_, mounting_, q), tool_pose(model_, mounting_, q_end), clauses_.free,
          shift};
}

bool ToolLine::is_there(std::span<const double> q, std::span<const double> q_end,
                        std::span<const int> named) const {
  return way_between(q, q_end, named).is_over();
}

/// Parameters that run evenly to their values at the end: the named ones, and of the others that
/// move the tool those that add nothing to what others nearer to the tool can do. Ascending.
std::vector<int> ToolLine::steered(std::span<const int> named) const {
  std::vector<int> result;
  for (const int i : named) {
    if (std::binary_search(moved_.begin(), moved_.end(), i)) result.push_back(i);
  }
  const auto& variables = chain_->variables();
  std::vector<int> spare, spare_here;
  std::size_t most = 0;
  for (const std::vector<std::array<double, 6>>& sample : samples_) {
    spare_here.clear();
    std::vector<PoseResidual> needed;  // orthonormal: what the tool can do by those looked at
    for (std::size_t v = 0; v < variables.size(); ++v) {  // tip first
      const int i = static_cast<int>(variables[v].parameter);
      if (std::find(named.begin(), named.end(), i) != named.end()) continue;
      PoseResidual column = Eigen::Map<const PoseResidual>(sample[v].data());
      const double length = column.norm();
      if (length <= kIdle) continue;
      for (const PoseResidual& each : needed) column -= each.dot(column) * each;
      for (const PoseResidual& each : needed) column -= each.dot(column) * each;
      if (column.norm() > kNothingNew * length) {
        needed.push_back(column.normalized());
      } else {
        spare_here.push_back(i);
      }
    }
    if (needed.size() <= most) continue;
    most = needed.size();
    spare = spare_here;
  }
  result.insert(result.end(), spare.begin(), spare.end());
  std::sort(result.begin(), result.end());
  return result;
}

/// The parameter that stands at the limit beyond which `wanted` leads.
int ToolLine::barring(std::span<const double> q, const std::vector<double>& wanted) const {
  for (const int i : moved_) {
    const Parameter& p = model_.parameters[at(i)];
    if (p.cyclic) continue;
    const double slack = 1e-6 * p.quantum;
    if (q[at(i)] >= p.upper - slack && wanted[at(i)] >= p.upper - slack) return i;
    if (q[at(i)] <= p.lower + slack && wanted[at(i)] <= p.lower + slack) return i;
  }
  return -1;
}

ToolLine::Step ToolLine::next_step(std::span<const double> q, std::span<const double> q_end,
                                   std::span<const int> named, std::span<double> steps) const {
  std::fill(steps.begin(), steps.end(), 0.0);
  const Way way = way_between(q, q_end, named);
  if (way.is_over()) return {Step::Kind::there, -1};

  const std::vector<int> even = steered(named);
  const std::vector<double> whole = change_between(q, q_end);
  const auto clauses_without_even = [&] {
    GoalClauses clauses = clauses_;
    clauses.locked.insert(clauses.locked.end(), even.begin(), even.end());
    std::sort(clauses.locked.begin(), clauses.locked.end());
    return clauses;
  };
  std::optional<GoalChain> without_even;
  if (!even.empty()) without_even.emplace(model_, clauses_without_even());
  const GoalChain& chain = without_even ? *without_even : *chain_;
  // An arm that moves alone has a formula; where that leads nowhere the search says how near it is.
  std::optional<ArmFormula> arm;
  const auto solve_on = [&](const GoalChain& searched, double part, bool by_formula) {
    std::vector<double> q_even(q.begin(), q.end());
    for (const int i : even) q_even[at(i)] += part * whole[at(i)];
    const GoalProblem problem(searched, mounting_, q_even, way.at(part));
    if (by_formula) {
      if (auto known = arm->solve(problem)) return std::pair(true, std::move(known->q));
    }
    GoalState state = damped_least_squares(problem, problem.at(q_even), problem.variables().size(),
                                           GoalPart::pose);
    return std::pair(problem.solved(state), std::move(state.q));
  };
  const auto solve = [&](double part) { return solve_on(chain, part, arm.has_value()); };
  // Why nothing leads to `part` of the way; `nearest`: the configuration that comes nearest to it.
  const auto why_not = [&](double part, const std::vector<double>& nearest) -> Step {
    if (const int limit = barring(q, nearest); limit >= 0) return {Step::Kind::limit, limit};
    for (const int i : moved_) {
      const Parameter& p = model_.parameters[at(i)];
      const double slack = 1e-6 * p.quantum;
      const bool at_range = nearest[at(i)] <= p.lower + slack || nearest[at(i)] >= p.upper - slack;
      if (p.cyclic || !at_range) continue;
      // Whether there is one beyond the range.
      RobotModel wider = model_;
      wider.parameters[at(i)].lower -= kBeyondRange;
      wider.parameters[at(i)].upper += kBeyondRange;
      const GoalChain beyond(wider, clauses_without_even());
      if (solve_on(beyond, part, false).first) return {Step::Kind::limit, i};
    }
    return {Step::Kind::none, -1};
  };
  const double most_orientation = math::radians(deviation_.orientation_deg);
  // The deviation of a step as a share of what is allowed, as far as it is looked at: no further
  // than to a moment at which it is too large. In the middle it is largest as a rule.
  const auto deviation = [&](const std::vector<double>& change, double part) {
    std::vector<double> q_there(q.begin(), q.end());
    for (std::size_t i = 0; i < q_there.size(); ++i) q_there[i] += change[i];
    StepMotion motion(mounting_, chain.elements());
    std::vector<double> between(q.size());
    std::pair<double, double> worst = {0, 0};
    const auto share = [&](const Bend& bend) {
      return std::max((worst.first + bend.position) / deviation_.position,
                      (worst.second + bend.orientation) / most_orientation);
    };
    const auto look = [&](int k, const auto& pose_at) {
      const double fraction = static_cast<double>(k) / kParts;
      configuration_at(q, q_there, fraction, between);
      update_derived(model_, mounting_, between);
      const auto [off, turned] = way.off(pose_at(between), part, fraction);
      worst = {std::max(worst.first, off), std::max(worst.second, turned)};
    };
    constexpr int kMiddle = kParts / 2;
    look(kMiddle, [&](const auto& q_now) { return tool_pose(model_, mounting_, q_now); });
    if (const double found = share({}); found > 1) return found;
    for (int k = 0; k <= kParts; ++k) {
      look(k, [&](const auto& q_now) { return motion.pose(q_now); });
      if (const double found = share({}); found > 1) return found;
    }
    return share(motion.bend());
  };

  // The goal's own configuration, where it is a step away and no other parameter is to change.
  const auto is_at_end = [&] {
    std::vector<double> q_whole(q.begin(), q.end());
    for (std::size_t i = 0; i < q_whole.size(); ++i) q_whole[i] += whole[i];
    update_derived(model_, mounting_, q_whole);
    return is_there(q_whole, q_end, named);
  };
  if (share_allowed(whole) == 1 && is_at_end() && deviation(whole, 1) <= 1) {
    std::copy(whole.begin(), whole.end(), steps.begin());
    return {Step::Kind::made, -1};
  }
  if (even.empty()) arm = ArmFormula::of({chain, mounting_, q, way.at(0)});
  // How the parameters run along it tells how long a step may be.
  const double probe = way.part(kProbe);
  const auto [leads_on, q_probe] = solve(probe);
  if (!leads_on) return why_not(probe, q_probe);
  const std::vector<double> first = change_between(q, q_probe);
  double longest = 0;  // of the changes, in steps
  for (const int i : moved_) {
    longest = std::max(longest, std::fabs(first[at(i)]) / model_.parameters[at(i)].step);
  }
  double part = std::min(1.0, probe * (longest > 0 ? 1 / longest : 1 / probe));
  const double shortest = way.part(kShortest);
  for (int trial = 0; trial < kMostTrials && part >= shortest; ++trial) {
    const auto [solved, q_there] = solve(part);
    const std::vector<double> change = change_between(q, q_there);
    const double allowed = share_allowed(change);
    // A step that is too long in a parameter is nearly as much too long on the way.
    double shorter = solved && allowed < 1 ? std::min(0.999 * allowed + 1e-3, 0.999) : 0.7;
    if (solved && allowed == 1) {
      const double found = deviation(change, part);
      if (found <= 1) {
        std::copy(change.begin(), change.end(), steps.begin());
        return {Step::Kind::made, -1};
      }
      // It grows with the square of the step.
      shorter = std::max(0.98 / std::sqrt(found), 0.1);
    }
    part *= shorter;
  }
  return {Step::Kind::none, -1};
}

}  // namespace rubicon::robot
