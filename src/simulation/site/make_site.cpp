#include "src/simulation/site/make_site.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "interpreter/check/driving_robots.hpp"
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

PreparedSite prepare_site(const interpreter::PlanModel& plan) {
  PreparedSite prepared;
  for (std::size_t i = 0; i < plan.site.size(); ++i) {
    prepared.obstacles.push_back(
        prepare_named({plan.site[i]}, site_shape_name(plan.site_names, i, plan.site.size())));
  }
  for (const interpreter::ComponentSpec& component : plan.components) {
    prepared.components.push_back(prepare_named(component.shapes, component.name));
  }
  for (const interpreter::MovingSpec& moving : plan.movings) {
    prepared.movings.push_back(prepare_named(moving.shapes, moving.name));
    prepared.air_above_movings.push_back(
        prepare_named(moving.overhead, "the air above " + moving.name));
  }
  for (const interpreter::RobotSpec& spec : plan.robots) make_starting_robot(spec, prepared.robots);
  if (!plan.carry.empty() && !plan.robots.empty()) {
    prepared.carry = prepare_named(plan.carry, "the load");
  }
  if (plan.support.mode != interpreter::SupportRules::Mode::off) {
    for (const interpreter::ComponentSpec& component : plan.components) {
      prepared.surfaces.push_back(make_support_surface(component.shapes));
    }
    for (const geometry::Shape& shape : plan.site) {
      prepared.surfaces.push_back(make_support_surface({shape}));
    }
  }
  return prepared;
}

namespace {

template <typename Dig>
void add_pit_of(const Dig& dig, const interpreter::TaskSpec& task,
                const interpreter::PlanModel& plan, SiteWorld& site) {
  site.add_pit({task.name, dig.soil, plan.earths[static_cast<std::size_t>(dig.earth)].X_WE,
                dig.before, dig.after});
}

}  // namespace

SiteWorld make_site(const interpreter::PlanModel& plan, const PreparedSite& prepared) {
  SiteWorld site(plan.contact);
  for (std::size_t i = 0; i < plan.site.size(); ++i) {
    site.add_obstacle(site_shape_name(plan.site_names, i, plan.site.size()), prepared.obstacles[i],
                      math::Pose::Identity());
  }
  if (!plan.site.empty()) site.show_obstacle("site", plan.site);
  for (std::size_t i = 0; i < plan.components.size(); ++i) {
    const interpreter::ComponentSpec& component = plan.components[i];
    const int added =
        site.add_component(component.name, prepared.components[i], component.X_WO, component.mass);
    site.show_component(added, component.shapes);
    if (component.people) site.add_people(added, component.shapes);
  }
  for (std::size_t i = 0; i < plan.movings.size(); ++i) {
    const interpreter::MovingSpec& moving = plan.movings[i];
    const int added = site.add_moving(moving.name, prepared.movings[i],
                                      prepared.air_above_movings[i], moving.timetable);
    site.show_moving(added, moving.shapes);
  }
  PreparedRobots bodies = prepared.robots;
  for (const interpreter::RobotSpec& spec : plan.robots) {
    StartingRobot robot = make_starting_robot(spec, bodies);
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
  const std::vector<bool> drives = interpreter::driving_robots(plan);
  for (std::size_t i = 0; i < drives.size(); ++i) {
    if (drives[i]) site.set_drives(static_cast<int>(i));
  }
  const bool any_drives = std::find(drives.begin(), drives.end(), true) != drives.end();
  for (const interpreter::TaskSpec& task : plan.tasks) {
    if (task.motion_dig) add_pit_of(*task.motion_dig, task, plan, site);
    if (any_drives && task.dig && task.dig->after) add_pit_of(*task.dig, task, plan, site);
  }
  if (plan.workspaces) {
    const interpreter::WorkspacesSpec& spec = *plan.workspaces;
    site.set_workspaces(
        {spec.robots, spec.reaction, spec.braking, spec.turn_braking, spec.foreseen(), spec.watch});
  }
  if (prepared.carry) site.attach_carry(0, prepared.carry);
  return site;
}

SiteWorld make_site(const interpreter::PlanModel& plan) {
  return make_site(plan, prepare_site(plan));
}

}  // namespace rubicon::site
