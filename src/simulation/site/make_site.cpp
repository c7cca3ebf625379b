#include "src/simulation/site/make_site.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "src/motion/robot/turns.hpp"

namespace rubicon::site {

collision::BodyPtr prepare_named(const std::vector<geometry::Shape>& shapes,
                                 const std::string& name) {
  if (shapes.empty()) return nullptr;
  try {
    return collision::prepare(shapes);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("the shape of {}: {}", name, error.what()));
  }
}

std::string site_shape_name(const std::vector<std::string>& names, std::size_t i,
                            std::size_t count) {
  if (i < names.size() && !names[i].empty()) return names[i];
  const auto named = std::count_if(names.begin(), names.end(),
                                   [](const std::string& name) { return !name.empty(); });
  return count - static_cast<std::size_t>(named) == 1 ? "site" : fmt::format("site {}", i + 1);
}

StartingRobot make_starting_robot(const interpreter::RobotSpec& spec, PreparedRobots& prepared) {
  const std::shared_ptr<const robot::RobotModel> model(spec.robot, &spec.robot->model);
  const robot::Mounting mounting{spec.X_WM, spec.start};
  std::vector<double> q = spec.start;
  robot::update_derived(*model, mounting, q);
  robot::normalise(*model, q);
  PreparedBodies& shared = prepared[spec.robot.get()];
  SiteRobot machine = make_site_robot(spec.name, model, mounting, shared);
  shared = {machine.bodies, machine.buffers};
  return {std::move(machine), std::move(q)};
}

SiteWorld make_site(const interpreter::PlanModel& plan) {
  SiteWorld site(plan.contact);
  for (std::size_t i = 0; i < plan.site.size(); ++i) {
    const std::string name = site_shape_name(plan.site_names, i, plan.site.size());
    site.add_obstacle(name, prepare_named({plan.site[i]}, name), math::Pose::Identity());
  }
  if (!plan.site.empty()) site.show_obstacle("site", plan.site);
  for (const interpreter::ComponentSpec& component : plan.components) {
    const int added =
        site.add_component(component.name, prepare_named(component.shapes, component.name),
                           component.X_WO, component.mass);
    site.show_component(added, component.shapes);
    if (component.people) site.add_people(added, component.shapes);
  }
  for (const interpreter::MovingSpec& moving : plan.movings) {
    const int added = site.add_moving(
        moving.name, prepare_named(moving.shapes, moving.name),
        prepare_named(moving.overhead, "the air above " + moving.name), moving.timetable);
    site.show_moving(added, moving.shapes);
  }
  PreparedRobots prepared;
  for (const interpreter::RobotSpec& spec : plan.robots) {
    StartingRobot robot = make_starting_robot(spec, prepared);
    site.add_robot(std::move(robot.machine), std::move(robot.q));
  }
  for (std::size_t i = 0; i < plan.networks.size(); ++i) {
    std::vector<traffic::Vehicle> vehicles;
    std::vector<int> robots;
    for (const interpreter::FleetSpec& fleet : plan.fleets) {
      if (fleet.network != static_cast<int>(i)) continue;
      for (std::size_t k = 0; k < fleet.robots.size(); ++k) {
        vehicles.push_back({fleet.speed, fleet.width, fleet.nodes[k]});
        robots.push_back(fleet.robots[k]);
      }
    }
    if (vehicles.empty()) continue;
    auto network = std::make_shared<const lanes::LaneNetwork>(plan.networks[i].description);
    site.add_network(plan.networks[i].name,
                     traffic::Traffic(std::move(network), std::move(vehicles)), std::move(robots));
  }
  if (!plan.carry.empty() && !plan.robots.empty()) {
    site.attach_carry(0, prepare_named(plan.carry, "the load"));
  }
  return site;
}

}  // namespace rubicon::site
