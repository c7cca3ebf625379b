#include "tests/unit/robot/robots.hpp"

#include <limits>

namespace rubicon::robot {
namespace {

using Kind = FormulaOp::Kind;

Formula joined(const Formula& a, const Formula& b, Kind kind) {
  Formula result = a;
  result.code.insert(result.code.end(), b.code.begin(), b.code.end());
  result.code.push_back({kind, 0, 0});
  return result;
}

Formula applied(const Formula& a, Kind kind) {
  Formula result = a;
  result.code.push_back({kind, 0, 0});
  return result;
}

}  // namespace

Formula number(double value) { return constant_formula(value); }
Formula of(int parameter) { return parameter_formula(parameter); }
Formula step_of(int parameter) { return {{{Kind::step, parameter, 0}}}; }
Formula start_of(int parameter) { return {{{Kind::start, parameter, 0}}}; }
Formula operator+(const Formula& a, const Formula& b) { return joined(a, b, Kind::add); }
Formula operator-(const Formula& a, const Formula& b) { return joined(a, b, Kind::subtract); }
Formula operator*(const Formula& a, const Formula& b) { return joined(a, b, Kind::multiply); }
Formula operator/(const Formula& a, const Formula& b) { return joined(a, b, Kind::divide); }
Formula operator-(const Formula& a) { return applied(a, Kind::negate); }
Formula sin_of(const Formula& a) { return applied(a, Kind::sin); }
Formula cos_of(const Formula& a) { return applied(a, Kind::cos); }

FrameElement trans(const Formula& a, const Formula& b, const Formula& c) {
  return {FrameElement::Kind::trans, a, b, c};
}
FrameElement trans(double a, double b, double c) { return trans(number(a), number(b), number(c)); }
FrameElement rotx(const Formula& a) { return {FrameElement::Kind::rotx, a, {}, {}}; }
FrameElement roty(const Formula& a) { return {FrameElement::Kind::roty, a, {}, {}}; }
FrameElement rotz(const Formula& a) { return {FrameElement::Kind::rotz, a, {}, {}}; }

int add_body(RobotModel& model, const std::string& name, int parent) {
  Body body;
  body.name = name;
  body.parent = parent;
  model.bodies.push_back(body);
  model.tool_body = static_cast<int>(model.bodies.size()) - 1;
  return model.tool_body;
}

int add_parameter(RobotModel& model, const std::string& name, double lower, double upper,
                  double step) {
  const int index = static_cast<int>(model.parameters.size());
  Parameter parameter;
  parameter.name = name;
  parameter.body = model.tool_body;
  parameter.display_name = name;
  for (Parameter& other : model.parameters) {
    if (other.name != name) continue;
    const std::string other_body = model.bodies[static_cast<std::size_t>(other.body)].name;
    other.display_name = other_body + "." + name;
    parameter.display_name = model.bodies.back().name + "." + name;
  }
  parameter.rotation = name == "psi" || name == "phi" || name == "theta";
  parameter.lower = lower;
  parameter.upper = upper;
  parameter.step = step;
  parameter.quantum = step > 0 ? step : 1;
  parameter.rule = of(index) + step_of(index);
  model.parameters.push_back(parameter);
  model.bodies.back().parameters.push_back(index);
  return index;
}

int add_cyclic(RobotModel& model, const std::string& name, double step) {
  const int index = add_parameter(model, name, -kInfinity, kInfinity, step);
  model.parameters.back().cyclic = true;
  return index;
}

Mounting mounting_of(const RobotModel& model, const Pose& X_WM) {
  return {X_WM, model.start_values()};
}

std::vector<double> one_step(const RobotModel& model, int parameter, double ds) {
  std::vector<double> steps(model.parameters.size(), 0.0);
  steps[static_cast<std::size_t>(parameter)] = ds;
  return steps;
}

RobotModel gantry() {
  RobotModel model;
  model.name = "gantry";
  add_body(model, "trolley", -1);
  const int x = add_parameter(model, "x", -10, 60, 0.5);
  const int y = add_parameter(model, "y", -30, 30, 0.5);
  model.bodies[0].frame = {trans(of(x), of(y), number(0))};
  return model;
}

RobotModel agent() {
  RobotModel model;
  model.name = "agent";
  add_body(model, "truck", -1);
  const int x = add_parameter(model, "x", -kInfinity, kInfinity, 0.5);
  const int y = add_parameter(model, "y", -kInfinity, kInfinity, 0);
  const int z = add_parameter(model, "z", -kInfinity, kInfinity, 0);
  const int theta = add_cyclic(model, "theta", 10);
  auto& p = model.parameters;
  p[0].rule = of(x) + step_of(x) * cos_of(of(theta)) - step_of(y) * sin_of(of(theta));
  p[1].rule = of(y) + step_of(x) * sin_of(of(theta)) + step_of(y) * cos_of(of(theta));
  p[2].rule = start_of(z);
  p[0].direct = p[1].direct = p[2].direct = false;
  p[2].free = false;
  model.bodies[0].frame = {trans(of(x), of(y), of(z)), rotz(of(theta))};
  return model;
}

RobotModel crane() {
  RobotModel model;
  model.name = "crane";
  add_body(model, "mast", -1);
  add_body(model, "jib", 0);
  const int theta = add_parameter(model, "theta", -180, 180, 5);
  model.bodies[1].frame = {rotz(of(theta))};
  add_body(model, "hook", 1);
  const int x = add_parameter(model, "x", 4, 50, 1);
  const int z = add_parameter(model, "z", 0, 42, 1);
  model.parameters[1].start = 20;
  model.parameters[2].start = 10;
  model.bodies[2].frame = {trans(of(x), number(0), of(z))};
  return model;
}

RobotModel finisher() {
  RobotModel model;
  model.name = "finisher";
  add_body(model, "base", -1);
  const int base_x = add_parameter(model, "x", 0, 40, 0.5);
  model.bodies[0].frame = {trans(of(base_x), number(0), number(20))};
  add_body(model, "carriage", 0);
  const int z = add_parameter(model, "z", -20, 0, 0.5);
  model.bodies[1].frame = {trans(number(0), number(-0.5), of(z))};
  add_body(model, "effector", 1);
  const int effector_x = add_parameter(model, "x", -1.5, 1.5, 0.25);
  model.bodies[2].frame = {trans(of(effector_x), number(0), number(0))};
  model.parameters[0].start = 2;
  model.parameters[1].start = -1;
  return model;
}

RobotModel crane_with_turning_hook() {
  RobotModel model;
  model.name = "crane";
  add_body(model, "mast", -1);
  model.bodies[0].frame = {trans(1, -2, 30), rotz(number(20))};
  add_body(model, "jib", 0);
  const int theta = add_cyclic(model, "theta", 5);
  model.bodies[1].frame = {rotz(of(theta)), trans(0.3, 0.7, 1.5), rotz(number(-4))};
  add_body(model, "trolley", 1);
  const int x = add_parameter(model, "x", 4, 50, 1);
  model.bodies[2].frame = {trans(of(x), number(0.2), number(-1))};
  add_body(model, "hook", 2);
  const int z = add_parameter(model, "z", -30, 0, 1);
  const int turn = add_cyclic(model, "theta", 5);
  model.bodies[3].frame = {trans(number(0), number(0), of(z)), rotz(of(turn))};
  model.tool_frame = {trans(0.4, -0.1, -2), rotx(number(180))};
  return model;
}

RobotModel planar_arm() {
  RobotModel model;
  model.name = "arm";
  const double lengths[] = {4, 3, 2};
  for (int i = 0; i < 3; ++i) {
    add_body(model, "link" + std::to_string(i), i - 1);
    const int phi = add_parameter(model, "phi", -170, 170, 2);
    if (i > 0) model.bodies.back().frame.push_back(trans(lengths[i - 1], 0, 0));
    model.bodies.back().frame.push_back(roty(of(phi)));
  }
  model.tool_frame = {trans(lengths[2], 0, 0)};
  return model;
}

RobotModel excavator() {
  RobotModel model;
  model.name = "excavator";
  add_body(model, "crawler", -1);
  add_body(model, "swing", 0);
  const int theta = add_cyclic(model, "theta", 5);
  model.bodies.back().frame = {trans(0, 0, 1.2), rotz(of(theta))};
  add_body(model, "boom", 1);
  const int boom = add_parameter(model, "phi", -70, 44, 2);
  model.bodies.back().frame = {trans(0.2, 0, 0.6), roty(of(boom))};
  add_body(model, "stick", 2);
  const int stick = add_parameter(model, "phi", 30, 152, 2);
  model.bodies.back().frame = {trans(5.7, 0, 0), roty(of(stick))};
  add_body(model, "bucket", 3);
  const int bucket = add_parameter(model, "phi", -33, 143, 2);
  model.bodies.back().frame = {trans(2.9, 0, 0), roty(of(bucket))};
  model.tool_frame = {trans(1.5, 0, 0)};
  for (Parameter& parameter : model.parameters) {
    if (!parameter.cyclic) parameter.start = (parameter.lower + parameter.upper) / 2;
  }
  return model;
}

}  // namespace rubicon::robot
