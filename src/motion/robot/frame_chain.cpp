#include "src/motion/robot/frame_chain.hpp"

#include <algorithm>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/inline_buffer.hpp"

namespace rubicon::robot {

namespace {

/// The bodies from the mounting frame to one, base first.
std::vector<int> path_to(const RobotModel& model, int body) {
  std::vector<int> path;
  for (; body >= 0; body = model.bodies[static_cast<std::size_t>(body)].parent) {
    path.push_back(body);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

void append(Pose& X, const FrameElement& element, const FormulaInput& input) {
  if (element.kind == FrameElement::Kind::trans) {
    const Vec3 t(element.a.evaluate(input), element.b.evaluate(input), element.c.evaluate(input));
    const auto R = X.linear();
    // Written out: a component that is 0 must not spread a rounding error into the others.
    for (int row = 0; row < 3; ++row) {
      X.translation()[row] += R(row, 0) * t.x() + R(row, 1) * t.y() + R(row, 2) * t.z();
    }
    return;
  }
  const auto [s, c] = math::sine_cosine_deg(element.a.evaluate(input));
  // A rotation about axis k turns the columns i and j that follow it in cyclic order.
  const int k = rotation_axis_index(element.kind);
  const int i = (k + 1) % 3;
  const int j = (k + 2) % 3;
  const Vec3 u = X.linear().col(i);
  const Vec3 v = X.linear().col(j);
  X.linear().col(i) = c * u + s * v;
  X.linear().col(j) = c * v - s * u;
}

void append(Pose& X, const FrameFormula& frame, const FormulaInput& input) {
  for (const FrameElement& element : frame) append(X, element, input);
}

Vec3 rotation_axis(FrameElement::Kind kind) { return Vec3::Unit(rotation_axis_index(kind)); }

Pose body_pose(const RobotModel& model, const Mounting& mounting, std::span<const double> q,
               int body) {
  InlineBuffer<int> chain(model.bodies.size());
  std::size_t length = 0;
  for (int b = body; b >= 0; b = model.bodies[static_cast<std::size_t>(b)].parent)
    chain[length++] = b;
  Pose X = mounting.X_WM;
  const FormulaInput input = {q, {}, mounting.starts};
  while (length > 0)
    append(X, model.bodies[static_cast<std::size_t>(chain[--length])].frame, input);
  return X;
}

std::vector<const FrameElement*> elements_to_body(const RobotModel& model, int body) {
  return relative_chain(model, body, -1).up;
}

std::vector<const FrameElement*> elements_to_tool(const RobotModel& model) {
  std::vector<const FrameElement*> elements = elements_to_body(model, model.tool_body);
  for (const FrameElement& element : model.tool_frame) elements.push_back(&element);
  return elements;
}

RelativeChain relative_chain(const RobotModel& model, int body, int other) {
  const std::vector<int> up = path_to(model, body);
  const std::vector<int> down = path_to(model, other);
  std::size_t common = 0;
  while (common < up.size() && common < down.size() && up[common] == down[common]) ++common;
  const auto elements_from = [&](const std::vector<int>& path) {
    std::vector<const FrameElement*> elements;
    for (std::size_t i = common; i < path.size(); ++i) {
      for (const FrameElement& each : model.bodies[static_cast<std::size_t>(path[i])].frame) {
        elements.push_back(&each);
      }
    }
    return elements;
  };
  return {elements_from(up), elements_from(down)};
}

std::vector<int> parameters_of(const RobotModel& model,
                               std::span<const FrameElement* const> elements) {
  std::vector<int> parameters;
  for (int i = 0; i < static_cast<int>(model.parameters.size()); ++i) {
    if (std::any_of(elements.begin(), elements.end(), [i](const FrameElement* each) {
          return each->a.depends_on_parameter(i) || each->b.depends_on_parameter(i) ||
                 each->c.depends_on_parameter(i);
        })) {
      parameters.push_back(i);
    }
  }
  return parameters;
}

std::vector<double> rates_by(const RobotModel& model, const Mounting& mounting,
                             std::span<const double> q, int parameter) {
  std::vector<double> rates(model.parameters.size(), 0.0);
  rates[static_cast<std::size_t>(parameter)] = 1;
  const FormulaInput input = {q, {}, mounting.starts};
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const Parameter& other = model.parameters[i];
    if (other.derived) rates[i] = other.derived_value.derivative(input, rates);
  }
  return rates;
}

}  // namespace rubicon::robot
