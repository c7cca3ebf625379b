#include "src/results/comparison/compare_travel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "src/motion/geometry/above.hpp"
#include "src/motion/guides/vehicle.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/motion/travel/grown_view.hpp"
#include "src/motion/travel/visibility.hpp"
#include "src/simulation/site/make_site.hpp"

namespace rubicon::comparison {

namespace {

/// Among things with a timetable a way may be waited out for ever; each second of it costs work.
/// It has its limit after an hour, or after this many times the straight line if that is longer.
constexpr double kLongestSeconds = 3600;
constexpr double kLongestDetour = 50;

/// What keeps a timetable, in the frame in which its shapes are, at its height.
void add_moving(const interpreter::MovingSpec& moving, travel::GrownView& view) {
  const auto& places = moving.timetable.places;
  const double height = places.front().X_WO.translation().z();
  travel::Obstacle* const obstacle =
      view.add(moving.name, moving.shapes, math::translation(0, 0, height));
  if (obstacle == nullptr) return;
  obstacle->repeat = moving.timetable.repeat;
  for (const geometry::TimedPlace& place : places) {
    const math::Pose& X = place.X_WO;
    if (X.translation().z() != height || !geometry::stands_upright(X)) {
      throw std::invalid_argument(fmt::format(
          "moving '{}' leans or goes up or down; --exact is for what stays upright at its height",
          moving.name));
    }
    obstacle->timetable.push_back({schedule::seconds_from_ticks(place.time),
                                   X.translation().head<2>(),
                                   math::atan2_deg(X.linear()(1, 0), X.linear()(0, 0))});
  }
}

std::vector<travel::Obstacle> obstacles_of(const interpreter::PlanModel& plan, int own,
                                           travel::GrownView view) {
  for (std::size_t i = 0; i < plan.site.size(); ++i) {
    view.add(site::site_shape_name(plan.site_names, i, plan.site.size()), {plan.site[i]},
             math::Pose::Identity());
  }
  for (const interpreter::ComponentSpec& component : plan.components) {
    view.add(component.name, component.shapes, component.X_WO);
  }
  for (int i = 0; i < static_cast<int>(plan.robots.size()); ++i) {
    if (i == own) continue;
    const interpreter::RobotSpec& robot = plan.robots[static_cast<std::size_t>(i)];
    const robot::RobotModel& model = robot.robot->model;
    std::vector<math::Pose> X_WB;
    robot::body_poses(model, {robot.X_WM, robot.start}, robot.start, X_WB);
    for (std::size_t body = 0; body < model.bodies.size(); ++body) {
      view.add(robot.name + "." + model.bodies[body].name, model.bodies[body].shapes, X_WB[body]);
    }
  }
  for (const interpreter::MovingSpec& moving : plan.movings) add_moving(moving, view);
  return std::move(view.obstacles());
}

/// The parameters of the robot where the task sends it.
std::vector<double> goal_of(const interpreter::GoalSpec& goal, std::vector<double> q) {
  if (goal.X_WG) {
    throw std::invalid_argument("the task goes to a frame; write where to: go x 30, y 4;");
  }
  for (const auto& [parameter, value] : goal.values) q[static_cast<std::size_t>(parameter)] = value;
  return q;
}

}  // namespace

TravelComparison compare_travel(const interpreter::PlanModel& plan, const std::string& task,
                                const travel::TravelSettings& settings) {
  int robot = 0;
  const interpreter::GoalSpec* goal = plan.goal ? &*plan.goal : nullptr;
  for (const interpreter::TaskSpec& each : plan.tasks) {
    if (each.name != task) continue;
    robot = each.robot;
    goal = each.go ? &*each.go : nullptr;
  }
  if (robot < 0 || goal == nullptr || plan.robots.empty()) {
    throw std::invalid_argument(
        fmt::format("'{}' does not go anywhere by itself; --exact is for tasks with go", task));
  }
  const interpreter::RobotSpec& spec = plan.robots[static_cast<std::size_t>(robot)];
  const robot::RobotModel& model = spec.robot->model;
  const guides::Vehicle vehicle(model, {spec.X_WM, spec.start});
  if (!vehicle.travels()) {
    throw std::invalid_argument(
        fmt::format("'{}' does not travel: no body of it has parameters x and y", spec.name));
  }
  TravelComparison comparison;
  comparison.plan = plan.name;
  comparison.task = task;
  comparison.radius = vehicle.radius(spec.start);
  comparison.start = vehicle.place(spec.start);
  comparison.destination = vehicle.place(goal_of(*goal, spec.start));
  travel::TravelQuery query;
  query.start = comparison.start;
  query.destination = comparison.destination;
  query.obstacles =
      obstacles_of(plan, robot, travel::GrownView(vehicle.heights(spec.start), comparison.radius));
  comparison.obstacles = query.obstacles.size();
  travel::TravelSettings own = settings;
  const double speed = model.parameters[static_cast<std::size_t>(vehicle.x())].speed;
  if (speed > 0) own.speed = speed;
  comparison.movings = static_cast<std::size_t>(
      std::count_if(query.obstacles.begin(), query.obstacles.end(),
                    [](const travel::Obstacle& each) { return !each.timetable.empty(); }));
  if (comparison.movings > 0) {
    const double straight = (comparison.destination - comparison.start).norm() / own.speed;
    own.most_time = std::min(own.most_time, std::max(kLongestSeconds, kLongestDetour * straight));
  }
  for (const travel::Method method : travel::kMethods) {
    const bool stands_only = method == travel::Method::kBug1 || method == travel::Method::kVisBug21;
    if (comparison.movings > 0 && stands_only) {
      comparison.trials.push_back({method, std::nullopt});
    } else {
      comparison.trials.push_back({method, travel::travel(method, query, own)});
    }
  }
  if (comparison.movings > 0) return comparison;
  const travel::VisibilityResult shortest = travel::shortest_way(query);
  if (shortest.reached) comparison.shortest = shortest.length;
  return comparison;
}

}  // namespace rubicon::comparison
