#include "src/results/replay/machine.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "src/motion/robot/turns.hpp"
#include "src/simulation/trace/formula_reader.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::replay {

namespace {

std::vector<std::string> names_of(const std::vector<trace::HeaderParameter>& parameters) {
  std::vector<std::string> names;
  for (const trace::HeaderParameter& parameter : parameters) names.push_back(parameter.name);
  return names;
}

robot::Parameter make_parameter(const trace::HeaderParameter& header, int body,
                                const std::vector<std::string>& names) {
  robot::Parameter parameter;
  parameter.name = parameter.display_name = header.name;
  parameter.body = body;
  parameter.rotation = header.rotation;
  parameter.cyclic = header.cyclic;
  parameter.step = header.step;
  parameter.speed = header.speed;
  parameter.loaded_speed = header.loaded_speed;
  parameter.acceleration = header.acceleration;
  parameter.start = header.start;
  parameter.derived = header.derived;
  parameter.direct = false;  // the formula says it all
  (header.derived ? parameter.derived_value : parameter.rule) =
      trace::read_formula(header.formula, names);
  return parameter;
}

robot::RobotModel make_model(const trace::HeaderRobot& header) {
  const std::vector<std::string> names = names_of(header.parameters);
  robot::RobotModel model;
  model.name = header.name;
  model.time_step = header.time_step;
  for (const trace::HeaderBody& body : header.bodies) {
    const int parent = body.parent.empty() ? -1 : model.find_body(body.parent);
    model.bodies.push_back({body.name,
                            parent,
                            {},
                            trace::read_frame(body.frame, names),
                            body.shapes,
                            body.buffer,
                            {}});
    if (!body.rope) continue;
    model.bodies.back().rope = robot::Rope{body.rope->radius, model.find_body(body.rope->from),
                                           body.rope->p_from, body.rope->p_to};
  }
  for (const trace::HeaderParameter& parameter : header.parameters) {
    const int body = model.find_body(parameter.body);
    model.bodies[static_cast<std::size_t>(body)].parameters.push_back(
        static_cast<int>(model.parameters.size()));
    model.parameters.push_back(make_parameter(parameter, body, names));
  }
  model.tool_body = model.find_body(header.tool_body);
  model.tool_frame = trace::read_frame(header.tool_frame, names);
  for (const auto& [a, b] : header.touching) {
    model.touching.emplace_back(model.find_body(a), model.find_body(b));
  }
  return model;
}

}  // namespace

Machine make_machine(const trace::HeaderRobot& header) {
  try {
    return {header.name, make_model(header), {header.X_WM, header.start}};
  } catch (const std::invalid_argument& error) {
    std::string name;
    trace::append_string(name, header.name);
    throw std::invalid_argument(fmt::format("robot {}: {}", name, error.what()));
  }
}

std::vector<double> start_values(const Machine& machine) {
  std::vector<double> q = machine.mounting.starts;
  robot::update_derived(machine.model, machine.mounting, q);
  robot::normalise(machine.model, q);
  return q;
}

}  // namespace rubicon::replay
