#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/frame_chain.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::robot {

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
      q_next[i] += 360 * std::floor(off / 360 + 0.5);
    }
  }
}

void update_derived(const RobotModel& model, const Mounting& mounting, std::span<double> q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Parameter& parameter = model.parameters[i];
    if (!parameter.derived) continue;
    q[i] = parameter.derived_value.evaluate({q, {}, mounting.starts});
    if (parameter.cyclic) q[i] = math::normalised_deg(q[i]);
  }
}

void normalise(const RobotModel& model, std::span<double> q) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (model.parameters[i].cyclic) q[i] = math::normalised_deg(q[i]);
  }
}

double nearest_turn_equivalent(const Parameter& parameter, double value, double current) {
  if (!parameter.rotation || !parameter.limited() || !std::isfinite(value)) return value;
  // A value that misses a limit by rounding stands on it: 1e-9 degrees are far below every step.
  constexpr double kRounding_deg = 1e-9;
  const double fewest = std::ceil((parameter.lower - kRounding_deg - value) / 360);
  const double most = std::floor((parameter.upper + kRounding_deg - value) / 360);
  if (!(fewest <= most)) return value;
  const double turns = (current - value) / 360;
  // Half a turn away both ways is a tie of directions.
  const double nearest = parameter.prefer < 0 ? std::ceil(turns - 0.5) : std::floor(turns + 0.5);
  const double equivalent = value + 360 * std::clamp(nearest, fewest, most);
  return std::clamp(equivalent, parameter.lower, parameter.upper);
}

}  // namespace rubicon::robot
