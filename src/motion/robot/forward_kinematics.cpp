#include "src/motion/math/turns.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::robot {

std::vector<double> configuration_at(std::span<const double> q0, std::span<const double> q1,
                                     double s) {
  std::vector<double> q(q0.size());
  configuration_at(q0, q1, s, q);
  return q;
}

void configuration_at(std::span<const double> q0, std::span<const double> q1, double s,
                      std::span<double> q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = s == 1 || q0[i] == q1[i] ? q1[i] : (1 - s) * q0[i] + s * q1[i];
  }
}

void body_poses(const RobotModel& model, const Mounting& mounting, std::span<const double> q,
                std::vector<Pose>& X_WB) {
  X_WB.resize(model.bodies.size());
  const FormulaInput input = {q, {}, mounting.starts};
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    X_WB[i] = body.parent < 0 ? mounting.X_WM : X_WB[static_cast<std::size_t>(body.parent)];
    append(X_WB[i], body.frame, input);
  }
}

Pose tool_pose(const RobotModel& model, const Mounting& mounting, std::span<const double> q) {
  Pose X = body_pose(model, mounting, q, model.tool_body);
  append(X, model.tool_frame, {q, {}, mounting.starts});
  return X;
}

void apply_rules(const RobotModel& model, const Mounting& mounting, std::span<const double> q,
                 std::span<const double> steps, std::span<double> q_next) {
  const FormulaInput input = {q, steps, mounting.starts};
  const std::size_t count = model.parameters.size();
  TrigonometryMemo memo;
  for (std::size_t first = 0; first < count;) {
    const int body = model.parameters[first].body;
    std::size_t last = first;
    bool stepped = false;
    for (; last < count && model.parameters[last].body == body; ++last)
      stepped = stepped || steps[last] != 0;
    // A step makes use of the rules of its own body only (LANGUAGE 5.1).
    for (std::size_t i = first; i < last; ++i) {
      const Parameter& parameter = model.parameters[i];
      if (!stepped || parameter.derived) {
        q_next[i] = q[i];
      } else if (parameter.direct) {
        q_next[i] = q[i] + steps[i];
      } else {
        q_next[i] = parameter.rule.evaluate(input, memo);
      }
    }
    first = last;
  }
  const FormulaInput next = {q_next, {}, mounting.starts};
  for (std::size_t i = 0; i < count; ++i) {
    const Parameter& parameter = model.parameters[i];
    if (!parameter.derived) continue;
    q_next[i] = parameter.derived_value.evaluate(next);
    // A cyclic one runs on from where it is, with the whole turns that q has left out.
    if (parameter.cyclic) {
      const double off = q[i] - parameter.derived_value.evaluate({q, {}, mounting.starts});
      q_next[i] += math::whole_turns_deg(off);
    }
  }
}

void update_derived(const RobotModel& model, const Mounting& mounting, std::span<double> q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Parameter& parameter = model.parameters[i];
    if (!parameter.derived) continue;
    q[i] = reduced(parameter, parameter.derived_value.evaluate({q, {}, mounting.starts}));
  }
}

}  // namespace rubicon::robot
