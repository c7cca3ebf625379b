#include "src/results/film/scene.hpp"

#include <fmt/format.h>
#include <simdjson.h>

#include <stdexcept>

#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::film {

namespace {

simdjson::dom::element parse(simdjson::dom::parser& parser, std::string_view text) {
  simdjson::dom::element root;
  const auto error = parser.parse(text.data(), text.size()).get(root);
  if (error != simdjson::SUCCESS) {
    throw std::invalid_argument(fmt::format("this is no JSON: {}", simdjson::error_message(error)));
  }
  return root;
}

SceneRobot read_robot(const trace::HeaderRobot& header) {
  SceneRobot robot;
  robot.name = header.name;
  for (std::size_t i = 0; i < header.parameters.size(); ++i) {
    robot.parameters.push_back(
        {header.parameters[i].name, header.parameters[i].cyclic, header.start[i]});
    millionths(header.start[i], "a start");
  }
  return robot;
}

SceneMesh read_mesh(const geometry::TriangleMesh& header) {
  SceneMesh mesh;
  for (const math::Vec3& vertex : header.vertices) {
    for (const double value : vertex) mesh.vertices.add(millionths(value, "a corner of a mesh"));
  }
  for (const auto& triangle : header.triangles) {
    for (const int corner : triangle) mesh.triangles.add(corner);
  }
  return mesh;
}

/// The member `meshes` as the head has it: where their numbers stand.
std::string meshes_json(const trace::TraceHeader& header) {
  std::string json = "[";
  for (std::size_t i = 0; i < header.meshes.size(); ++i) {
    if (i > 0) json += ',';
    json += fmt::format(
        R"({{"closed":{},"vertices":"mesh.{}.vertices","triangles":"mesh.{}.triangles"}})",
        header.meshes[i]->closed, i, i);
  }
  return json + ']';
}

/// The members of the header as they are written, but for the numbers of meshes.
std::string header_json(const trace::TraceHeader& header, std::string_view line) {
  simdjson::dom::parser parser;
  const simdjson::dom::object members = parse(parser, line);
  std::string json = "{";
  for (const auto member : members) {
    if (json.size() > 1) json += ',';
    trace::append_string(json, member.key);
    json += ':';
    json += member.key == "meshes" ? meshes_json(header) : simdjson::minify(member.value);
  }
  return json + '}';
}

}  // namespace

Scene read_scene(const trace::TraceHeader& header, std::string_view line) {
  Scene scene;
  scene.plan = header.plan;
  scene.short_form = header.short_form;
  for (const trace::HeaderRobot& robot : header.robots) {
    scene.robots.push_back(read_robot(robot));
    scene.robot_numbers.emplace(robot.name, static_cast<int>(scene.robots.size()) - 1);
  }
  int components = 0;
  for (const trace::HeaderComponent& component : header.components) {
    scene.component_numbers.emplace(component.name, components++);
  }
  for (const auto& mesh : header.meshes) scene.meshes.push_back(read_mesh(*mesh));
  scene.json = header_json(header, line);
  return scene;
}

std::string tidy_json(std::string_view text) {
  simdjson::dom::parser parser;
  return simdjson::minify(parse(parser, text));
}

}  // namespace rubicon::film
