#include "tests/unit/guides/guide_machines.hpp"

#include <utility>

namespace rubicon::test {

namespace {

using robot::FormulaOp;
using robot::FrameElement;
using Kind = FormulaOp::Kind;

constexpr int kSamples = 400;

robot::Formula of(std::vector<FormulaOp> code) { return {std::move(code)}; }

robot::Parameter plain(const char* name, int body, bool rotation, double lower, double upper,
                       double step, double speed) {
  robot::Parameter p;
  p.name = p.display_name = name;
  p.body = body;
  p.rotation = rotation;
  p.lower = lower;
  p.upper = upper;
  p.step = p.quantum = step;
  p.speed = p.loaded_speed = speed;
  return p;
}

FrameElement translation(robot::Formula a, robot::Formula b, robot::Formula c) {
  return {FrameElement::Kind::trans, std::move(a), std::move(b), std::move(c)};
}

FrameElement rotation(FrameElement::Kind kind, robot::Formula a) {
  return {kind, std::move(a), {}, {}};
}

robot::Formula number(double value) { return robot::constant_formula(value); }

}  // namespace

robot::RobotModel gantry() {
  robot::RobotModel model;
  model.name = "gantry";
  model.parameters = {plain("x", 0, false, 0, 10, 1, 1), plain("y", 0, false, 0, 10, 1, 1)};
  robot::Body body;
  body.name = "trolley";
  body.parameters = {0, 1};
  body.frame = {translation(robot::parameter_formula(0), robot::parameter_formula(1), number(0))};
  model.bodies = {body};
  return model;
}

robot::RobotModel vehicle() {
  robot::RobotModel model;
  model.name = "vehicle";
  model.parameters = {plain("x", 0, false, -50, 50, 0.5, 1), plain("y", 0, false, -50, 50, 0, 0),
                      plain("theta", 0, true, 0, 0, 10, 20)};
  robot::Parameter& x = model.parameters[0];
  robot::Parameter& y = model.parameters[1];
  robot::Parameter& theta = model.parameters[2];
  theta.cyclic = true;
  theta.lower = -std::numeric_limits<double>::infinity();
  theta.upper = std::numeric_limits<double>::infinity();
  x.direct = y.direct = false;
  y.quantum = 0.5;
  const FormulaOp step{Kind::step, 0, 0};
  const FormulaOp heading{Kind::parameter, 2, 0};
  x.rule = of({{Kind::parameter, 0, 0},
               step,
               heading,
               {Kind::cos, 0, 0},
               {Kind::multiply, 0, 0},
               {Kind::add, 0, 0}});
  y.rule = of({{Kind::parameter, 1, 0},
               step,
               heading,
               {Kind::sin, 0, 0},
               {Kind::multiply, 0, 0},
               {Kind::add, 0, 0}});
  theta.rule = of({{Kind::parameter, 2, 0}, {Kind::step, 2, 0}, {Kind::add, 0, 0}});
  robot::Body body;
  body.name = "truck";
  body.parameters = {0, 1, 2};
  body.frame = {translation(robot::parameter_formula(0), robot::parameter_formula(1), number(0)),
                rotation(FrameElement::Kind::rotz, robot::parameter_formula(2))};
  model.bodies = {body};
  return model;
}

robot::RobotModel steered_vehicle() {
  robot::RobotModel model = vehicle();
  for (const int place : {0, 1}) {
    robot::Parameter& p = model.parameters[static_cast<std::size_t>(place)];
    p.rule = of({{Kind::parameter, place, 0},
                 {Kind::step, 0, 0},
                 {Kind::parameter, 2, 0},
                 {Kind::step, 2, 0},
                 {Kind::constant, 0, 2},
                 {Kind::divide, 0, 0},
                 {Kind::add, 0, 0},
                 {place == 0 ? Kind::cos : Kind::sin, 0, 0},
                 {Kind::multiply, 0, 0},
                 {Kind::add, 0, 0}});
  }
  model.parameters[2].direct = false;
  return model;
}

robot::RobotModel excavator() {
  robot::RobotModel model;
  model.name = "excavator";
  model.parameters = {plain("theta", 0, true, 0, 0, 5, 15), plain("boom", 1, true, -57, 65, 5, 5.5),
                      plain("stick", 2, true, 26, 146, 5, 22.5),
                      plain("bucket", 3, true, 44, 215, 5, 31.71)};
  model.parameters[0].cyclic = true;
  const auto up = [](int parameter) {
    return of({{Kind::parameter, parameter, 0}, {Kind::negate, 0, 0}});
  };
  const auto inner = [](int parameter) {
    return of({{Kind::constant, 0, 180}, {Kind::parameter, parameter, 0}, {Kind::subtract, 0, 0}});
  };
  const auto body = [&](const char* name, int parameter, robot::FrameFormula frame) {
    robot::Body each;
    each.name = name;
    each.parent = parameter - 1;
    each.parameters = {parameter};
    each.frame = std::move(frame);
    model.bodies.push_back(std::move(each));
  };
  body("upper", 0, {rotation(FrameElement::Kind::rotz, robot::parameter_formula(0))});
  body("boom", 1,
       {translation(number(0.228), number(0), number(1.957)),
        rotation(FrameElement::Kind::roty, up(1))});
  body("stick", 2,
       {translation(number(5.648), number(0), number(0)),
        rotation(FrameElement::Kind::roty, inner(2))});
  body("bucket", 3,
       {translation(number(2.889), number(0), number(0)),
        rotation(FrameElement::Kind::roty, inner(3))});
  model.tool_body = 3;
  model.tool_frame = {translation(number(1.562), number(0), number(0))};
  return model;
}

robot::Mounting standing(const robot::RobotModel& model) {
  return {math::Pose::Identity(), model.start_values()};
}

bool PredicateTests::sweeps_free(std::span<const double> q_from, std::span<const double> q_to) {
  std::vector<double> q(q_from.size());
  for (int k = 0; k <= kSamples; ++k) {
    const double s = static_cast<double>(k) / kSamples;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = q_from[i] + s * (q_to[i] - q_from[i]);
    if (blocked_(q)) return false;
  }
  return true;
}

}  // namespace rubicon::test
