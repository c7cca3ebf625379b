#include <utility>

#include "src/motion/math/index.hpp"
#include "src/simulation/site/site_world.hpp"

namespace rubicon::site {

using math::at;

void SiteWorld::show_obstacle(std::string name, const std::vector<geometry::Shape>& shapes) {
  shown_.push_back({std::move(name), &shapes, math::Pose::Identity()});
}

void SiteWorld::show_component(int component, const std::vector<geometry::Shape>& shapes) {
  if (shown_components_.size() <= at(component)) shown_components_.resize(at(component) + 1);
  shown_components_[at(component)] = &shapes;
}

void SiteWorld::show_moving(int moving, const std::vector<geometry::Shape>& shapes) {
  if (shown_movings_.size() <= at(moving)) shown_movings_.resize(at(moving) + 1);
  shown_movings_[at(moving)] = &shapes;
}

std::vector<guides::Thing> SiteWorld::things(int robot) const {
  std::vector<guides::Thing> things = shown_;
  for (std::size_t i = 0; i < shown_components_.size(); ++i) {
    const Component& component = components_[i];
    if (shown_components_[i] == nullptr || !component.standing) continue;
    things.push_back({component.name, shown_components_[i], component.X_WO});
  }
  for (int i = 0; i < static_cast<int>(robots_.size()); ++i) {
    if (i == robot) continue;
    const RobotEntry& other = entry(i);
    const robot::RobotModel& model = *other.robot.model;
    std::vector<math::Pose> X_WB;
    robot::body_poses(model, other.robot.mounting, other.q, X_WB);
    for (std::size_t body = 0; body < model.bodies.size(); ++body) {
      if (model.bodies[body].shapes.empty()) continue;
      things.push_back({other.robot.body_names[body], &model.bodies[body].shapes, X_WB[body],
                        other.robot.fixed_bodies[body] ? -1 : i});
    }
    if (!other.load || other.load->component < 0) continue;
    const std::size_t component = at(other.load->component);
    if (component >= shown_components_.size() || shown_components_[component] == nullptr) continue;
    things.push_back(
        {other.load->name, shown_components_[component], tool_pose(i) * other.load->X_TO, i});
  }
  for (std::size_t i = 0; i < shown_movings_.size(); ++i) {
    const MovingThing& moving = movings_[i];
    if (shown_movings_[i] == nullptr || !moving.is_present(now_)) continue;
    things.push_back(
        {moving.name(), shown_movings_[i], moving.pose(now_), -1, static_cast<int>(i)});
  }
  return things;
}

std::vector<SiteWorld::NamedPart> SiteWorld::parts_of_others(int robot) const {
  std::vector<NamedPart> parts;
  for (int i = 0; i < static_cast<int>(robots_.size()); ++i) {
    if (i == robot) continue;
    const RobotEntry& other = entry(i);
    for (ReservedPart& part : reserved_parts(other)) {
      if (part.is_buffer) continue;
      std::string name = part_name(other, part.part);
      parts.push_back({std::move(name), std::move(part)});
    }
  }
  return parts;
}

}  // namespace rubicon::site
