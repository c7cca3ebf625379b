#include "src/results/verify/replay/site_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/replay/dug_soil.hpp"
#include "src/results/verify/replay/hauled_soil.hpp"
#include "src/results/verify/replay/step_rules.hpp"

namespace rubicon::verify {

namespace {

using math::at;

bool meant_to_touch(const SceneRobot& robot, int a, int b) {
  if (robot.bodies[at(a)].parent == b || robot.bodies[at(b)].parent == a) return true;
  for (const auto& [rope, body] : {std::pair(a, b), std::pair(b, a)}) {
    const auto& each = robot.bodies[at(rope)].rope;
    if (each && each->from == body) return true;
  }
  return std::any_of(robot.touching.begin(), robot.touching.end(), [&](const auto& pair) {
    return pair == std::pair(a, b) || pair == std::pair(b, a);
  });
}

RobotParts make_robot_parts(const SceneRobot& robot, const std::vector<MeshData>& meshes) {
  RobotParts parts;
  parts.mechanism = std::make_unique<Mechanism>(robot);
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    const SceneBody& body = robot.bodies[i];
    const std::string name = robot.name + "." + body.name;
    if (body.rope) {
      const std::vector<double> starts = start_values(robot);
      const Vec3 from_W = parts.mechanism->pose(body.rope->from, starts) * body.rope->p_from;
      const Pose X_WF = parts.mechanism->pose(body.parent, starts);
      parts.solids.push_back(
          make_capsule(X_WF.inverse(Eigen::Isometry) * from_W, body.rope->p_to, body.rope->radius));
      parts.bodies.push_back(
          {parts.solids.back().get(), body.parent, Pose::Identity(), name, &*body.rope});
      parts.body_index.push_back(static_cast<int>(i));
      continue;
    }
    parts.solids.push_back(make_solid(body.shapes, meshes));
    if (!parts.solids.back()) continue;
    parts.bodies.push_back(
        {parts.solids.back().get(), static_cast<int>(i), Pose::Identity(), name});
    parts.body_index.push_back(static_cast<int>(i));
    if (!(body.buffer > 0)) continue;
    parts.grown.push_back(grown(*parts.solids.back(), body.buffer));
    RobotPart& buffer = parts.buffers.emplace_back(parts.bodies.back());
    buffer.solid = parts.grown.back().get();
    buffer.name = buffer_name(name);
    buffer.is_buffer = true;
  }
  const int count = static_cast<int>(parts.bodies.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (meant_to_touch(robot, parts.body_index[at(a)], parts.body_index[at(b)])) continue;
      parts.own_pairs.emplace_back(a, b);
    }
  }
  return parts;
}

}  // namespace

std::string buffer_name(const std::string& body) { return "the buffer of " + body; }

std::string air_above(const std::string& moving) { return "the air above " + moving; }

std::string overhead_name(const std::string& task) { return "the air above the zone of " + task; }

SiteParts make_site_parts(const Trace& trace, const std::vector<TaskRun>& runs,
                          const std::vector<Stay>& stays, Ticks until) {
  const Scene& scene = trace.scene;
  SiteParts parts;
  for (std::size_t i = 0; i < scene.site.size(); ++i) {
    const std::string name = scene.site_name(i);
    parts.obstacles.push_back(
        {name, make_solid({scene.site[i]}, scene.meshes), Pose::Identity(), 0, until, -1, -1});
  }
  for (const SceneComponent& component : scene.components) {
    parts.components.push_back(make_solid(component.shapes, scene.meshes));
  }
  const std::set<int> dug = add_dug_soil(trace, runs, stays, parts.obstacles);
  add_heaps(trace, runs, until, parts.obstacles);
  for (const Stay& stay : stays) {
    if (dug.contains(stay.component)) continue;
    const auto& solid = parts.components[at(stay.component)];
    if (!solid) continue;
    parts.obstacles.push_back({scene.components[at(stay.component)].name, solid, stay.X_WO,
                               stay.from, stay.to, stay.component, -1});
  }
  std::erase_if(parts.obstacles, [](const Obstacle& each) { return !each.solid; });
  for (const TaskRun& run : runs) {
    if (!run.happened || run.task < 0) continue;
    const SceneTask& task = scene.tasks[at(run.task)];
    if (task.zones.empty()) continue;
    parts.zones.push_back({"the zone of " + task.name, make_solid(task.zones, scene.meshes),
                           Pose::Identity(), run.start, run.end, -1, run.robot});
    if (task.zones_overhead.empty()) continue;
    parts.zones.push_back({overhead_name(task.name), make_solid(task.zones_overhead, scene.meshes),
                           Pose::Identity(), run.start, run.end, -1, run.robot, true});
  }
  for (const SceneRobot& robot : scene.robots) {
    parts.robots.push_back(make_robot_parts(robot, scene.meshes));
  }
  parts.carry = make_solid(scene.carry, scene.meshes);
  return parts;
}

}  // namespace rubicon::verify
