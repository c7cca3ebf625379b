#include "interpreter/check/driving_robots.hpp"

#include <algorithm>

namespace rubicon::interpreter {

namespace {

bool is_vehicle(const robot::RobotModel& model) {
  const robot::Body& body = model.bodies[static_cast<std::size_t>(model.tool_body)];
  const auto has = [&](const char* name) {
    return std::any_of(body.parameters.begin(), body.parameters.end(), [&](int each) {
      return model.parameters[static_cast<std::size_t>(each)].name == name;
    });
  };
  return body.parent < 0 && !body.shapes.empty() && has("x") && has("y") && !has("z");
}

}  // namespace

std::vector<bool> driving_robots(const PlanModel& plan) {
  std::vector<bool> drives;
  for (const RobotSpec& robot : plan.robots) drives.push_back(is_vehicle(robot.robot->model));
  const auto add = [&](const TaskSpec& task) {
    if (task.haul && task.robot >= 0) drives[static_cast<std::size_t>(task.robot)] = true;
  };
  for (const TaskSpec& task : plan.tasks) {
    add(task);
    for (const TaskSpec& choice : task.choices) add(choice);
  }
  return drives;
}

}  // namespace rubicon::interpreter
