#include "src/results/film/scene.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <utility>

#include "src/results/film/record_simdjson.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::film {

namespace {

constexpr std::int64_t kTraceVersion = 1;
constexpr std::size_t kCorners = 3;

simdjson::dom::element parse(simdjson::dom::parser& parser, std::string_view text) {
  simdjson::dom::element root;
  const auto error = parser.parse(text.data(), text.size()).get(root);
  if (error != simdjson::SUCCESS) {
    throw std::invalid_argument(fmt::format("this is no JSON: {}", simdjson::error_message(error)));
  }
  return root;
}

SceneRobot read_robot(const Record& record) {
  SceneRobot robot;
  robot.name = record.text("name");
  const Record start = record.object("start");
  for (const auto each : record.array("parameters")) {
    const Record parameter(each);
    SceneParameter& read = robot.parameters.emplace_back();
    read.name = parameter.text("name");
    read.cyclic = parameter.truth("cyclic");
    read.start = start.number(read.name);
    millionths(read.start, "a start");
  }
  return robot;
}

SceneMesh read_mesh(const Record& record) {
  SceneMesh mesh;
  for (const auto each : record.array("vertices")) {
    mesh.vertices.add(millionths(as_number(each), "a corner of a mesh"));
  }
  if (mesh.vertices.count() % kCorners != 0) {
    throw std::invalid_argument("the corners of a mesh have three numbers each");
  }
  const auto corners = static_cast<std::int64_t>(mesh.vertices.count() / kCorners);
  for (const auto each : record.array("triangles")) {
    const std::int64_t corner = as_whole(each);
    if (corner < 0 || corner >= corners) {
      throw std::invalid_argument(
          fmt::format("a mesh has {} corners and a triangle at number {}", corners, corner));
    }
    mesh.triangles.add(corner);
  }
  if (mesh.triangles.count() % kCorners != 0) {
    throw std::invalid_argument("the triangles of a mesh have three corners each");
  }
  return mesh;
}

/// The member `meshes` as the head has it: where their numbers stand.
void append_meshes(std::string& out, Scene& scene, const Record& header) {
  out += '[';
  for (const auto each : header.array("meshes")) {
    const Record record(each);
    if (!scene.meshes.empty()) out += ',';
    out += fmt::format(
        R"({{"closed":{},"vertices":"mesh.{}.vertices","triangles":"mesh.{}.triangles"}})",
        record.truth("closed"), scene.meshes.size(), scene.meshes.size());
    scene.meshes.push_back(read_mesh(record));
  }
  out += ']';
}

std::string header_json(Scene& scene, const Record& header) {
  std::string json = "{";
  std::set<std::string_view> names;
  for (const auto member : header.members()) {
    // Some readers of JSON take the first of two, others the last.
    if (!names.insert(member.key).second) {
      throw std::invalid_argument(fmt::format("the header of the trace has two '{}'", member.key));
    }
    if (json.size() > 1) json += ',';
    trace::append_string(json, member.key);
    json += ':';
    if (member.key == "meshes") {
      append_meshes(json, scene, header);
    } else {
      json += simdjson::minify(member.value);
    }
  }
  return json + '}';
}

}  // namespace

Scene read_scene(std::string_view line) {
  simdjson::dom::parser parser;
  const Record header(parse(parser, line));
  if (header.text_or_empty("format") != "rubicon-trace") {
    throw std::invalid_argument("this is no trace: its first line does not say so");
  }
  if (header.whole("version") != kTraceVersion) {
    throw std::invalid_argument(fmt::format("the trace has version {}; this rubicon reads {}",
                                            header.whole("version"), kTraceVersion));
  }
  Scene scene;
  scene.plan = header.text("plan");
  scene.short_form = header.text("form") == "short";
  for (const auto each : header.array("robots")) {
    scene.robots.push_back(read_robot(Record(each)));
    scene.robot_numbers.emplace(scene.robots.back().name,
                                static_cast<int>(scene.robots.size()) - 1);
  }
  int components = 0;
  for (const auto each : header.array("components")) {
    scene.component_numbers.emplace(Record(each).text("name"), components++);
  }
  scene.json = header_json(scene, header);
  return scene;
}

std::string tidy_json(std::string_view text) {
  simdjson::dom::parser parser;
  return simdjson::minify(parse(parser, text));
}

}  // namespace rubicon::film
