#include "src/simulation/taskplan/load_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/simulation/site/load_chart.hpp"

namespace rubicon::taskplan {

namespace {

/// m: how much nearer in than its goal the tool may set something down.
double leeway(const interpreter::TaskSpec& task, const robot::RobotModel& model) {
  double sum = std::max(task.within.length, 0.0);
  for (const auto& [parameter, allowed] : task.within.values) {
    if (!model.parameters[static_cast<std::size_t>(parameter)].rotation) sum += allowed;
  }
  return sum;
}

}  // namespace

std::optional<std::string> too_heavy(const Stage& stage, int task) {
  const interpreter::TaskSpec& spec = stage.spec(task);
  if (!spec.move || spec.robot < 0) return std::nullopt;
  const interpreter::RobotSpec& machine = stage.robot_spec(spec.robot);
  const robot::RobotModel& model = machine.robot->model;
  const interpreter::ComponentSpec& component =
      stage.plan.components[static_cast<std::size_t>(*spec.move)];
  if (model.capacity.empty() || component.mass <= 0) return std::nullopt;
  const auto radius_at = [&](const math::Pose& X_WO) {
    return site::chart_radius(machine.X_WM, (X_WO * component.X_OG).translation());
  };
  const double up = radius_at(stage.site.X_WO(*spec.move));
  const double down = radius_at(spec.X_WO_goal);
  const double beside = leeway(spec, model);
  if (site::may_hang(model.capacity, component.mass, up) &&
      site::may_hang_between(model.capacity, component.mass, std::max(down - beside, 0.0),
                             down + beside)) {
    return std::nullopt;
  }
  return fmt::format(
      "too heavy: {} has {:g} kg, the load chart of {} allows {:g} kg at {:g} m, where it is taken "
      "up, and {:g} kg at {:g} m, where it is set down",
      component.name, component.mass, machine.name, site::capacity_near(model.capacity, up), up,
      site::capacity_near(model.capacity, down), down);
}

}  // namespace rubicon::taskplan
