#include "src/site/site_world.hpp"

#include <cassert>
#include <utility>

namespace rubicon::site {

void SiteWorld::add_obstacle(std::string name, collision::BodyPtr body, const math::Pose& X_WB) {
  insert(name, body, X_WB);
  ++changes_;
}

int SiteWorld::add_component(std::string name, collision::BodyPtr body, const math::Pose& X_WO,
                             double mass) {
  Component& component = components_.emplace_back();
  component.name = std::move(name);
  component.body = std::move(body);
  component.mass = mass;
  stand(component, X_WO);
  return static_cast<int>(components_.size()) - 1;
}

int SiteWorld::add_robot(SiteRobot robot, std::vector<double> q) {
  RobotEntry& added = robots_.emplace_back();
  added.robot = std::move(robot);
  added.q = std::move(q);
  set_down(added);
  ++changes_;
  return static_cast<int>(robots_.size()) - 1;
}

void SiteWorld::activate(int robot) {
  if (active_ == robot) return;
  if (active_ >= 0) set_down(entry(active_));
  active_ = robot;
  pick_up(entry(robot));
}

void SiteWorld::attach(int robot, int component) {
  Component& taken = components_[static_cast<std::size_t>(component)];
  assert(taken.standing && !entry(robot).load);
  const math::Pose X_TW = tool_pose(robot).inverse(Eigen::Isometry);
  entry(robot).load = Load{taken.name, taken.body, X_TW * taken.X_WO, taken.mass, component};
  lift(taken);
}

void SiteWorld::attach_carry(int robot, collision::BodyPtr body) {
  entry(robot).load = Load{"load", std::move(body), math::Pose::Identity(), 0, -1};
  ++changes_;
}

void SiteWorld::detach(int robot) {
  assert(entry(robot).load && entry(robot).load->component >= 0);
  const Load load = *entry(robot).load;
  entry(robot).load.reset();
  stand(components_[static_cast<std::size_t>(load.component)], tool_pose(robot) * load.X_TO);
}

void SiteWorld::remove(int component) { lift(components_[static_cast<std::size_t>(component)]); }

void SiteWorld::set_configuration(int robot, std::vector<double> q) {
  assert(robot == active_);
  entry(robot).q = std::move(q);
  ++entry(robot).steps;
}

bool SiteWorld::stands(int component) const {
  return components_[static_cast<std::size_t>(component)].standing;
}

const math::Pose& SiteWorld::X_WO(int component) const {
  return components_[static_cast<std::size_t>(component)].X_WO;
}

const std::string& SiteWorld::component_name(int component) const {
  return components_[static_cast<std::size_t>(component)].name;
}

math::Pose SiteWorld::tool_pose(int robot) const {
  const RobotEntry& at_work = entry(robot);
  return robot::tool_pose(*at_work.robot.model, at_work.robot.mounting, at_work.q);
}

std::uint64_t SiteWorld::version(int robot) const {
  std::uint64_t version = changes_;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (static_cast<int>(i) != robot) version += robots_[i].steps;
  }
  return version;
}

SiteWorld::Snapshot SiteWorld::snapshot() const {
  Snapshot snapshot;
  for (const Component& component : components_) {
    snapshot.components.push_back({component.standing, component.X_WO});
  }
  for (const RobotEntry& robot : robots_) snapshot.robots.push_back({robot.q, robot.load});
  return snapshot;
}

void SiteWorld::restore(const Snapshot& snapshot) {
  for (std::size_t i = 0; i < components_.size(); ++i) {
    Component& component = components_[i];
    const Snapshot::Place& place = snapshot.components[i];
    const bool moved = component.X_WO.matrix() != place.X_WO.matrix();
    if (component.standing && (moved || !place.standing)) lift(component);
    if (place.standing && !component.standing) stand(component, place.X_WO);
    component.X_WO = place.X_WO;
  }
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    RobotEntry& robot = robots_[i];
    const bool waits = static_cast<int>(i) != active_;
    if (waits) pick_up(robot);
    robot.q = snapshot.robots[i].q;
    robot.load = snapshot.robots[i].load;
    if (waits) set_down(robot);
  }
  ++changes_;
}

collision::ObstacleId SiteWorld::insert(const std::string& name, const collision::BodyPtr& body,
                                        const math::Pose& X_WB) {
  const collision::ObstacleId id = obstacles_.insert(body, X_WB);
  names_[id] = name;
  return id;
}

void SiteWorld::erase(collision::ObstacleId id) {
  obstacles_.remove(id);
  names_.erase(id);
}

void SiteWorld::stand(Component& component, const math::Pose& X_WO) {
  component.X_WO = X_WO;
  component.standing = true;
  if (component.body) component.id = insert(component.name, component.body, X_WO);
  ++changes_;
}

void SiteWorld::lift(Component& component) {
  if (component.id) erase(*component.id);
  component.id.reset();
  component.standing = false;
  ++changes_;
}

void SiteWorld::set_down(RobotEntry& robot) {
  const SiteRobot& machine = robot.robot;
  std::vector<math::Pose> X_WB;
  robot::body_poses(*machine.model, machine.mounting, robot.q, X_WB);
  for (std::size_t i = 0; i < machine.bodies.size(); ++i) {
    if (!machine.bodies[i]) continue;
    robot.ids.push_back(insert(machine.body_names[i], machine.bodies[i], X_WB[i]));
  }
  if (robot.load && robot.load->body) {
    const math::Pose X_WT = robot::tool_pose(*machine.model, machine.mounting, robot.q);
    robot.ids.push_back(insert(robot.load->name, robot.load->body, X_WT * robot.load->X_TO));
  }
}

void SiteWorld::pick_up(RobotEntry& robot) {
  for (const collision::ObstacleId id : robot.ids) erase(id);
  robot.ids.clear();
}

}  // namespace rubicon::site
