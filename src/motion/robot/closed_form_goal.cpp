#include "src/motion/robot/closed_form_goal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::robot {

namespace {

/// File units by which a value may miss its limit, or the value now, by rounding; it is then set to
/// it.
constexpr double kSnap = 1e-10;

/// Metres from an axis within which a point has no bearing from it.
constexpr double kOnAxis = 1e-12;

constexpr int kNone = -1;

}  // namespace

/// A moving element of the chain and the constant frame behind it.
struct ChainJoint {
  bool rotation = false;                                  ///< about z; else a translation
  bool is_turned = false;                                 ///< about x or y, or the other way round
  std::array<int, 3> parameters = {kNone, kNone, kNone};  ///< a rotation has its parameter first
  std::array<double, 3> slopes = {1, 1, 1};               ///< m or degrees per file unit of each
  Pose after = Pose::Identity();
};

/// The frames between mounting and tool: what moves, and constant frames.
struct JointChain {
  Pose before = Pose::Identity();
  std::vector<ChainJoint> joints;

  /// No rotation about anything but z.
  bool is_plain() const {
    return std::none_of(joints.begin(), joints.end(),
                        [](const ChainJoint& joint) { return joint.is_turned; });
  }
};

namespace {

/// What a formula is to the solver: constant; slope * parameter + offset of one free parameter; or
/// anything more.
struct Argument {
  enum class Kind { constant, parameter, other };
  Kind kind = Kind::constant;
  int parameter = kNone;
  double slope = 1;
  double offset = 0;
};

/// One value on the stack of a formula: slope * parameter + offset.
struct Term {
  double slope = 0;
  double offset = 0;
  bool moves = false;
};

std::optional<Term> product(const Term& a, const Term& b) {
  if (a.moves && b.moves) return std::nullopt;
  const Term& moving = b.moves ? b : a;
  const double factor = b.moves ? a.offset : b.offset;
  return Term{moving.slope * factor, moving.offset * factor, moving.moves};
}

Argument argument_of(const GoalProblem& problem, const Formula& formula) {
  constexpr Argument kOther{Argument::Kind::other};
  using Kind = FormulaOp::Kind;
  Argument argument;
  for (const FormulaOp& op : formula.code) {
    if (op.kind != Kind::parameter) continue;
    const Parameter& parameter = problem.model().parameters[static_cast<std::size_t>(op.index)];
    if (parameter.derived) return kOther;
    if (!problem.moves(op.index)) continue;
    if (argument.parameter != kNone && argument.parameter != op.index) return kOther;
    argument.parameter = op.index;
  }
  if (argument.parameter == kNone) return argument;
  argument.kind = Argument::Kind::parameter;
  std::vector<Term> stack;
  const auto pop = [&stack] {
    const Term term = stack.back();
    stack.pop_back();
    return term;
  };
  for (const FormulaOp& op : formula.code) {
    if (op.kind == Kind::constant) {
      stack.push_back({0, op.value, false});
    } else if (op.kind == Kind::parameter) {
      const auto index = static_cast<std::size_t>(op.index);
      stack.push_back(op.index == argument.parameter ? Term{1, 0, true}
                                                     : Term{0, problem.q_now()[index], false});
    } else if (op.kind == Kind::start) {
      stack.push_back({0, problem.mounting().starts[static_cast<std::size_t>(op.index)], false});
    } else if (op.kind == Kind::negate) {
      const Term a = pop();
      stack.push_back({-a.slope, -a.offset, a.moves});
    } else if (op.kind == Kind::add || op.kind == Kind::subtract) {
      const Term b = pop();
      const Term a = pop();
      const double sign = op.kind == Kind::add ? 1 : -1;
      stack.push_back({a.slope + sign * b.slope, a.offset + sign * b.offset, a.moves || b.moves});
    } else if (op.kind == Kind::multiply) {
      const Term b = pop();
      const Term a = pop();
      const std::optional<Term> both = product(a, b);
      if (!both) return kOther;
      stack.push_back(*both);
    } else {
      return kOther;
    }
  }
  argument.slope = stack.back().slope;
  argument.offset = stack.back().offset;
  const bool is_usable =
      std::isfinite(argument.slope) && argument.slope != 0 && std::isfinite(argument.offset);
  return is_usable ? argument : kOther;
}

/// Takes z to the axis that an element turns about, by exchanging axes; exact.
Pose from_z_axis(FrameElement::Kind kind) {
  Pose C = Pose::Identity();
  if (kind == FrameElement::Kind::rotx) {
    C.linear() << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  } else if (kind == FrameElement::Kind::roty) {
    C.linear() << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  }
  return C;
}

/// The chain with its constant elements gathered, neighbouring translations joined; nothing if some
/// element is no plain joint.
std::optional<JointChain> joint_chain(const GoalProblem& problem) {
  JointChain chain;
  chain.before = problem.mounting().X_WM;
  const FormulaInput now = {problem.q_now(), {}, problem.mounting().starts};
  for (const FrameElement* element : problem.elements()) {
    const bool rotation = element->kind != FrameElement::Kind::trans;
    FrameElement constant;  // the element without what moves it, if anything does
    constant.kind = element->kind;
    ChainJoint joint;
    joint.rotation = rotation;
    bool moving = false;
    const std::array<const Formula*, 3> given = {&element->a, &element->b, &element->c};
    const std::array<Formula*, 3> formulas = {&constant.a, &constant.b, &constant.c};
    for (std::size_t i = 0; i < (rotation ? 1 : 3); ++i) {
      const Argument argument = argument_of(problem, *given[i]);
      if (argument.kind == Argument::Kind::other) return std::nullopt;
      if (argument.kind == Argument::Kind::constant) {
        if (!rotation) *formulas[i] = *given[i];
        continue;
      }
      // A turn with a gear is left to the search.
      if (rotation && std::fabs(argument.slope) != 1) return std::nullopt;
      joint.parameters[i] = argument.parameter;
      joint.slopes[i] = argument.slope;
      if (argument.offset != 0) {
        formulas[i]->code.push_back({FormulaOp::Kind::constant, 0, argument.offset});
      }
      moving = true;
    }
    Pose& behind = chain.joints.empty() ? chain.before : chain.joints.back().after;
    if (!moving) {
      append(behind, *element, now);
      continue;
    }
    if (rotation) {
      joint.is_turned = element->kind != FrameElement::Kind::rotz || joint.slopes[0] != 1;
      const Pose C = from_z_axis(element->kind);
      behind = behind * C;
      joint.after = C.inverse();
    }
    ChainJoint* previous = chain.joints.empty() ? nullptr : &chain.joints.back();
    const bool joins = !rotation && previous != nullptr && !previous->rotation &&
                       previous->after.linear() == math::Mat3::Identity();
    if (!joins) {
      append(joint.after, constant, now);
      chain.joints.push_back(joint);
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (joint.parameters[i] == kNone) continue;
      if (previous->parameters[i] != kNone) return std::nullopt;
      previous->parameters[i] = joint.parameters[i];
      previous->slopes[i] = joint.slopes[i];
    }
    append(previous->after, constant, now);
  }
  // A parameter that moves two elements is no plain joint.
  std::vector<int> used;
  for (const ChainJoint& joint : chain.joints) {
    for (const int parameter : joint.parameters) {
      if (parameter == kNone) continue;
      if (std::find(used.begin(), used.end(), parameter) != used.end()) return std::nullopt;
      used.push_back(parameter);
    }
  }
  return chain;
}

/// Turn about z that brings R as near as possible to the identity when taken back, degrees.
double yaw_deg(const math::Mat3& R) {
  return math::atan2_deg(R(1, 0) - R(0, 1), R(0, 0) + R(1, 1));
}

bool keeps_z(const Pose& X) { return Vec3(X.linear().col(2)) == Vec3::UnitZ(); }

/// Sets a parameter within its range, to its value now where only rounding separates them; false if
/// out of range.
bool set(const GoalProblem& problem, std::vector<double>& q, int parameter, double value) {
  const auto index = static_cast<std::size_t>(parameter);
  const Parameter& p = problem.model().parameters[index];
  const double now = problem.q_now()[index];
  if (p.limited()) {
    value = nearest_turn_equivalent(p, value, now);
  } else if (p.rotation) {
    value = math::nearest_equivalent_deg(value, now);
  }
  if (std::fabs(value - now) <= kSnap) value = now;
  if (!(value >= p.lower - kSnap && value <= p.upper + kSnap)) return false;
  q[index] = std::clamp(value, p.lower, p.upper);
  return true;
}

/// The same for the length by which a joint is to slide along one of its axes.
bool set_slide(const GoalProblem& problem, std::vector<double>& q, const ChainJoint& joint,
               std::size_t axis, double length) {
  return set(problem, q, joint.parameters[axis], length / joint.slopes[axis]);
}

/// A vehicle or a gantry with a hook that turns: translations, then a turn; without the turn a
/// plain gantry.
std::vector<std::vector<double>> vehicle_solutions(const GoalProblem& problem,
                                                   const JointChain& chain) {
  const ChainJoint& slide = chain.joints[0];
  const ChainJoint* turn = chain.joints.size() > 1 ? &chain.joints[1] : nullptr;
  // before * trans(t) * slide.after * rotz(theta) * turn.after = goal
  const Pose H = chain.before.inverse() * problem.goal();
  std::vector<double> q = problem.q_now();
  Pose rest = slide.after;
  if (turn != nullptr) {
    const math::Mat3 turned =
        slide.after.linear().transpose() * H.linear() * turn->after.linear().transpose();
    if (!set(problem, q, turn->parameters[0], yaw_deg(turned))) return {};
    const double theta = q[static_cast<std::size_t>(turn->parameters[0])];
    rest = rest * math::rotation_z_deg(theta) * turn->after;
  }
  const Vec3 t = H.translation() - rest.translation();
  for (std::size_t i = 0; i < 3; ++i) {
    if (slide.parameters[i] != kNone &&
        !set_slide(problem, q, slide, i, t[static_cast<Eigen::Index>(i)])) {
      return {};
    }
  }
  return {q};
}

std::vector<std::vector<double>> crane_solutions(const GoalProblem& problem,
                                                 const JointChain& chain) {
  const ChainJoint& boom = chain.joints[0];
  const ChainJoint& trolley = chain.joints[1];
  const ChainJoint* hook = chain.joints.size() > 2 ? &chain.joints[2] : nullptr;
  if (!keeps_z(boom.after) || (hook != nullptr && !keeps_z(trolley.after))) return {};
  const bool along_x = trolley.parameters[0] != kNone;
  if (along_x == (trolley.parameters[1] != kNone)) return {};

  // In the frame the mast turns in: where the hook's axis (without one: the tool) has to be.
  const Pose H = chain.before.inverse() * problem.goal();
  Vec3 target = H.translation();
  double heading_deg = 0;
  if (hook != nullptr) {
    heading_deg = yaw_deg(H.linear() * hook->after.linear().transpose());
    target -= math::rotation_z_deg(heading_deg) * Vec3(hook->after.translation());
  }

  // Before the mast turns, the hook's axis is at offset + radius * direction, horizontally.
  Vec3 offset = boom.after * Vec3(trolley.after.translation());
  const double height = target.z() - offset.z();
  offset.z() = 0;
  const Vec3 direction = boom.after.linear().col(along_x ? 0 : 1);
  const double distance = std::sqrt(target.x() * target.x() + target.y() * target.y());
  const double along = offset.dot(direction);
  const double across_squared = std::max(0.0, offset.dot(offset) - along * along);
  const double squared = distance * distance - across_squared;
  if (squared < -kOnAxis) return {};
  const double root = std::sqrt(std::max(0.0, squared));

  std::vector<std::vector<double>> solutions;
  for (const double radius : {-along + root, -along - root}) {
    std::vector<double> q = problem.q_now();
    const auto theta = static_cast<std::size_t>(boom.parameters[0]);
    if (distance > kOnAxis) {
      const Vec3 at_rest = offset + radius * direction;
      const double bearing_deg =
          math::atan2_deg(target.y(), target.x()) - math::atan2_deg(at_rest.y(), at_rest.x());
      if (!set(problem, q, boom.parameters[0], bearing_deg)) continue;
    }
    if (!set_slide(problem, q, trolley, along_x ? 0 : 1, radius)) continue;
    if (trolley.parameters[2] != kNone && !set_slide(problem, q, trolley, 2, height)) continue;
    if (hook != nullptr) {
      const double others_deg =
          q[theta] + yaw_deg(boom.after.linear()) + yaw_deg(trolley.after.linear());
      if (!set(problem, q, hook->parameters[0], heading_deg - others_deg)) continue;
    }
    solutions.push_back(std::move(q));
  }
  return solutions;
}

/// The last four joints of a chain: a turn, then three in one plane that it turns.
constexpr std::size_t kArmJoints = 4;

double turn_of(const ChainJoint& joint, const std::vector<double>& q) {
  return joint.slopes[0] * q[static_cast<std::size_t>(joint.parameters[0])];
}

/// The frames of joints that stay as they are, in a row.
Pose frames_now(const GoalProblem& problem, const JointChain& chain, std::size_t count) {
  Pose X = chain.before;
  for (std::size_t i = 0; i < count; ++i) {
    const ChainJoint& joint = chain.joints[i];
    if (joint.rotation) {
      X = X * math::rotation_z_deg(turn_of(joint, problem.q_now()));
    } else {
      Vec3 t = Vec3::Zero();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (joint.parameters[axis] == kNone) continue;
        t[static_cast<Eigen::Index>(axis)] =
            joint.slopes[axis] * problem.q_now()[static_cast<std::size_t>(joint.parameters[axis])];
      }
      X = X * math::translation(t.x(), t.y(), t.z());
    }
    X = X * joint.after;
  }
  return X;
}

bool is_arm(const JointChain& chain) {
  if (chain.joints.size() < kArmJoints) return false;
  const ChainJoint* const arm = chain.joints.data() + (chain.joints.size() - kArmJoints);
  for (std::size_t i = 0; i < kArmJoints; ++i) {
    if (!arm[i].rotation) return false;
  }
  return keeps_z(arm[1].after) && keeps_z(arm[2].after) && !keeps_z(arm[0].after);
}

/// An excavator's arm. Whatever is below it stays as it is: tip first, it moves only if the arm
/// does not get there alone. The axis of the last joint says how far the arm is turned; it bends
/// one way, then the other.
std::vector<std::vector<double>> arm_solutions(const GoalProblem& problem,
                                               const JointChain& chain) {
  const std::size_t first = chain.joints.size() - kArmJoints;
  const ChainJoint* const arm = chain.joints.data() + first;
  const Pose X_WY = frames_now(problem, chain, first);
  const Pose H = X_WY.inverse(Eigen::Isometry) * problem.goal() * arm[3].after.inverse();

  std::vector<double> turned = problem.q_now();
  const Vec3 axis = arm[0].after.linear().col(2);
  const Vec3 wanted = H.linear().col(2);
  if (axis.x() * axis.x() + axis.y() * axis.y() < kOnAxis) return {};
  const double turn_deg =
      math::atan2_deg(wanted.y(), wanted.x()) - math::atan2_deg(axis.y(), axis.x());
  if (!set(problem, turned, arm[0].parameters[0], arm[0].slopes[0] * turn_deg)) return {};

  // In the plane: the last axis is to be at p, turned by heading_deg.
  const Pose in_plane =
      (math::rotation_z_deg(turn_of(arm[0], turned)) * arm[0].after).inverse(Eigen::Isometry) * H;
  const Vec3 p = in_plane.translation();
  const double heading_deg = yaw_deg(in_plane.linear());
  const Vec3 upper = arm[1].after.translation();
  const Vec3 lower = arm[2].after.translation();
  const double a = std::sqrt(upper.x() * upper.x() + upper.y() * upper.y());
  const double b = std::sqrt(lower.x() * lower.x() + lower.y() * lower.y());
  const double d = std::sqrt(p.x() * p.x() + p.y() * p.y());
  if (std::min({a, b, d}) <= kOnAxis) return {};
  const double area = (a + b + d) * (a + b - d) * (d + a - b) * (d - a + b);
  const double sine = std::sqrt(std::max(0.0, area));
  const double cosine = d * d - a * a - b * b;
  const double upper_deg = math::atan2_deg(upper.y(), upper.x());
  const double lower_deg = math::atan2_deg(lower.y(), lower.x());
  const double middle_deg = yaw_deg(arm[1].after.linear());
  const double last_deg = yaw_deg(arm[2].after.linear());

  std::vector<std::vector<double>> solutions;
  for (const double sign : {1.0, -1.0}) {
    const double bend_deg = math::atan2_deg(sign * sine, cosine);
    std::vector<double> q = turned;
    const double second = bend_deg + upper_deg - lower_deg - middle_deg;
    if (!set(problem, q, arm[2].parameters[0], arm[2].slopes[0] * second)) continue;
    const double second_set = turn_of(arm[2], q);
    const Vec3 reach = upper + math::rotation_z_deg(middle_deg + second_set) * lower;
    const double lifted = math::atan2_deg(p.y(), p.x()) - math::atan2_deg(reach.y(), reach.x());
    if (!set(problem, q, arm[1].parameters[0], arm[1].slopes[0] * lifted)) continue;
    const double third = heading_deg - turn_of(arm[1], q) - middle_deg - second_set - last_deg;
    if (!set(problem, q, arm[3].parameters[0], arm[3].slopes[0] * third)) continue;
    solutions.push_back(std::move(q));
  }
  return solutions;
}

/// Of solutions the best that meets the position, and, if asked for, the orientation.
std::optional<GoalState> best_of(const GoalProblem& problem,
                                 std::vector<std::vector<double>> solutions, bool whole) {
  std::optional<GoalState> best;
  for (std::vector<double>& q : solutions) {
    GoalState state = problem.at(std::move(q));
    if (whole ? !problem.solved(state) : state.position_error > kSolved) continue;
    if (!best || problem.better(state, *best)) best = std::move(state);
  }
  return best;
}

}  // namespace

ArmFormula::ArmFormula(JointChain chain)
    : chain_(std::make_shared<const JointChain>(std::move(chain))) {}

std::optional<ArmFormula> ArmFormula::of(const GoalProblem& problem) {
  if (problem.variables().size() != kArmJoints || problem.turns_freely()) return std::nullopt;
  auto chain = joint_chain(problem);
  if (!chain || chain->joints.size() != kArmJoints || !is_arm(*chain)) return std::nullopt;
  return ArmFormula(std::move(*chain));
}

std::optional<GoalState> ArmFormula::solve(const GoalProblem& problem) const {
  return best_of(problem, arm_solutions(problem, *chain_), true);
}

std::optional<GoalState> closed_form_goal(const GoalProblem& problem) {
  const auto chain = joint_chain(problem);
  if (!chain) return std::nullopt;
  if (is_arm(*chain)) return best_of(problem, arm_solutions(problem, *chain), true);
  if (!chain->is_plain() || problem.locks_any()) return std::nullopt;
  const std::vector<ChainJoint>& joints = chain->joints;
  std::vector<std::vector<double>> solutions;
  if (!joints.empty() && !joints[0].rotation &&
      (joints.size() == 1 || (joints.size() == 2 && joints[1].rotation))) {
    solutions = vehicle_solutions(problem, *chain);
  } else if ((joints.size() == 2 || (joints.size() == 3 && joints[2].rotation)) &&
             joints[0].rotation && !joints[1].rotation) {
    solutions = crane_solutions(problem, *chain);
  }
  return best_of(problem, std::move(solutions), false);
}

}  // namespace rubicon::robot
