#include "src/results/verify/input/read_robot.hpp"

#include <algorithm>
#include <iterator>

#include "src/results/verify/input/read_shapes.hpp"

namespace rubicon::verify {

namespace {

int body_index(const SceneRobot& robot, const std::string& name) {
  const auto found = std::find_if(robot.bodies.begin(), robot.bodies.end(),
                                  [&](const SceneBody& body) { return body.name == name; });
  if (found == robot.bodies.end()) throw UnreadableInput("expected a body, found '" + name + "'");
  return static_cast<int>(std::distance(robot.bodies.begin(), found));
}

std::vector<std::string> read_names(const JsonFields& fields) {
  std::vector<std::string> names;
  for (const Json& object : fields.array("parameters")) {
    names.push_back(JsonFields(object, "a parameter").text("name"));
  }
  return names;
}

SceneRope read_rope(const JsonFields& fields, const SceneBody& body, const SceneRobot& robot) {
  const auto point = [&](const char* name) {
    const Json& list = fields.array(name);
    if (list.size() != 3) fields.fail("three numbers as a point of a rope");
    Vec3 p;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!list[i].is_number()) fields.fail("three numbers as a point of a rope");
      p[static_cast<Eigen::Index>(i)] = list[i].get<double>();
    }
    return p;
  };
  SceneRope rope;
  rope.radius = fields.number("radius");
  rope.from = body_index(robot, fields.text("from"));
  rope.p_from = point("p_from");
  rope.p_to = point("p_to");
  if (!(rope.radius > 0)) fields.fail("a rope with a radius");
  if (body.parent < 0) fields.fail("a rope that goes to a body");
  return rope;
}

/// Bodies stand after the one they stand on.
void read_bodies(const JsonFields& fields, const std::vector<std::string>& names,
                 std::size_t meshes, SceneRobot& robot) {
  for (const Json& object : fields.array("bodies")) {
    const JsonFields body(object, "a body");
    SceneBody read;
    read.name = body.text("name");
    if (body.has("parent")) read.parent = body_index(robot, body.text("parent"));
    read.frame = parse_frame(body.text("frame"), names);
    read.shapes = read_shapes(body.array("shapes"), meshes);
    if (body.has("buffer")) read.buffer = body.number("buffer");
    if (body.has("rope")) read.rope = read_rope(body.object("rope"), read, robot);
    robot.bodies.push_back(std::move(read));
  }
  if (robot.bodies.empty()) fields.fail("bodies");
}

SceneParameter read_parameter(const JsonFields& fields, const std::vector<std::string>& names,
                              const SceneRobot& robot) {
  SceneParameter read;
  read.name = fields.text("name");
  read.body = body_index(robot, fields.text("body"));
  read.rotation = fields.text("kind") == "rotation";
  read.cyclic = fields.truth("cyclic");
  read.prefers_less = fields.number("prefer") < 0;
  if (fields.has("lower")) read.lower = fields.number("lower");
  if (fields.has("upper")) read.upper = fields.number("upper");
  read.step = fields.number("step");
  read.speed = fields.number("speed");
  read.loaded_speed = fields.number("loaded_speed");
  if (fields.has("acceleration")) read.acceleration = fields.number("acceleration");
  read.derived = fields.has("derived");
  read.rule = Formula::parse(fields.text(read.derived ? "derived" : "rule"), names);
  return read;
}

}  // namespace

SceneDeviation read_deviation(const JsonFields& fields) {
  return {fields.number("position"), fields.number("orientation")};
}

SceneRobot read_robot(const JsonFields& fields, std::size_t meshes) {
  SceneRobot robot;
  robot.name = fields.text("name");
  robot.X_WM = fields.pose("pose");
  robot.time_step = fields.number("time_step");
  const std::vector<std::string> names = read_names(fields);
  read_bodies(fields, names, meshes, robot);
  const JsonFields starts = fields.object("start");
  for (const Json& object : fields.array("parameters")) {
    robot.parameters.push_back(read_parameter(JsonFields(object, "a parameter"), names, robot));
    robot.starts.push_back(starts.number(robot.parameters.back().name.c_str()));
  }
  const JsonFields tool = fields.object("tool");
  robot.tool_body = body_index(robot, tool.text("body"));
  robot.tool_frame = parse_frame(tool.text("frame"), names);
  for (const Json& pair : fields.array("touching")) {
    if (!pair.is_array() || pair.size() != 2) fields.fail("pairs of bodies as 'touching'");
    robot.touching.emplace_back(body_index(robot, text_of(pair[0], "a body")),
                                body_index(robot, text_of(pair[1], "a body")));
  }
  if (fields.has("deviation")) robot.deviation = read_deviation(fields.object("deviation"));
  for (const Json& point : fields.array("capacity")) {
    if (!point.is_array() || point.size() != 2) fields.fail("radius and mass as 'capacity'");
    robot.capacity.emplace_back(number_of(point[0], "a radius"), number_of(point[1], "a mass"));
  }
  return robot;
}

}  // namespace rubicon::verify
