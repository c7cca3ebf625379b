#include "src/results/verify/replay/site_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rubicon::verify {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool meant_to_touch(const SceneRobot& robot, int a, int b) {
  if (robot.bodies[at(a)].parent == b || robot.bodies[at(b)].parent == a) return true;
  return std::any_of(robot.touching.begin(), robot.touching.end(), [&](const auto& pair) {
    return pair == std::pair(a, b) || pair == std::pair(b, a);
  });
}

RobotParts make_robot_parts(const SceneRobot& robot, const std::vector<MeshData>& meshes) {
  RobotParts parts;
  parts.mechanism = std::make_unique<Mechanism>(robot);
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    parts.solids.push_back(make_solid(robot.bodies[i].shapes, meshes));
    if (!parts.solids.back()) continue;
    parts.bodies.push_back({parts.solids.back().get(), static_cast<int>(i), Pose::Identity(),
                            robot.name + "." + robot.bodies[i].name});
  }
  const int count = static_cast<int>(parts.bodies.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (meant_to_touch(robot, parts.bodies[at(a)].frame, parts.bodies[at(b)].frame)) continue;
      parts.own_pairs.emplace_back(a, b);
    }
  }
  return parts;
}

}  // namespace

SiteParts make_site_parts(const Trace& trace, const std::vector<TaskRun>& runs,
                          const std::vector<Stay>& stays, Ticks until) {
  const Scene& scene = trace.scene;
  SiteParts parts;
  for (std::size_t i = 0; i < scene.site.size(); ++i) {
    const std::string name = scene.site.size() == 1 ? "site" : fmt::format("site {}", i + 1);
    parts.obstacles.push_back(
        {name, make_solid({scene.site[i]}, scene.meshes), Pose::Identity(), 0, until, -1, -1});
  }
  for (const SceneComponent& component : scene.components) {
    parts.components.push_back(make_solid(component.shapes, scene.meshes));
  }
  for (const Stay& stay : stays) {
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
  }
  for (const SceneRobot& robot : scene.robots) {
    parts.robots.push_back(make_robot_parts(robot, scene.meshes));
  }
  parts.carry = make_solid(scene.carry, scene.meshes);
  return parts;
}

}  // namespace rubicon::verify
