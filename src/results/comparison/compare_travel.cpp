#include "src/results/comparison/compare_travel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/motion/travel/grow.hpp"
#include "src/motion/travel/plan_view.hpp"
#include "src/motion/travel/ring.hpp"
#include "src/motion/travel/visibility.hpp"
#include "src/simulation/site/make_site.hpp"

namespace rubicon::comparison {

namespace {

using travel::Vec2;

/// Sine of how far something upright may lean: only rounding is meant.
constexpr double kUpright = 1e-9;

/// A vehicle in the plan view: the body that its parameters x and y move.
class Vehicle {
 public:
  Vehicle(const interpreter::RobotSpec& spec)
      : model_(spec.robot->model), mounting_{spec.X_WM, spec.start}, q_(spec.start) {
    robot::update_derived(model_, mounting_, q_);
    robot::body_poses(model_, mounting_, q_, X_WB_);
    for (std::size_t body = 0; body < model_.bodies.size() && y_ < 0; ++body) {
      x_ = parameter_of(body, "x");
      y_ = x_ < 0 ? -1 : parameter_of(body, "y");
      body_ = body;
    }
    if (y_ >= 0) return;
    throw std::invalid_argument(
        fmt::format("'{}' does not travel: no body of it has parameters x and y", spec.name));
  }

  Vec2 place() const { return X_WB_[body_].translation().head<2>(); }

  /// Where its place is when it has come to the goal.
  Vec2 place_at(const interpreter::GoalSpec& goal) const {
    if (goal.X_WG) {
      throw std::invalid_argument("the task goes to a frame; write where to: go x 30, y 4;");
    }
    std::vector<double> q = q_;
    for (const auto& [parameter, value] : goal.values)
      q[static_cast<std::size_t>(parameter)] = value;
    robot::update_derived(model_, mounting_, q);
    std::vector<math::Pose> X_WB;
    robot::body_poses(model_, mounting_, q, X_WB);
    return X_WB[body_].translation().head<2>();
  }

  double radius() const {
    double radius = 0;
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      radius = std::max(radius, travel::reach_about(place(), model_.bodies[i].shapes, X_WB_[i]));
    }
    return radius;
  }

  /// Of a vehicle without a shape: all heights.
  travel::Heights heights() const {
    travel::Heights all{HUGE_VAL, -HUGE_VAL};
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      const travel::Heights each = travel::heights_of(model_.bodies[i].shapes, X_WB_[i]);
      all.low = std::min(all.low, each.low);
      all.high = std::max(all.high, each.high);
    }
    return all.low < all.high ? all : travel::Heights{-HUGE_VAL, HUGE_VAL};
  }

  double speed() const { return model_.parameters[static_cast<std::size_t>(x_)].speed; }

 private:
  int parameter_of(std::size_t body, const char* name) const {
    for (const int each : model_.bodies[body].parameters) {
      if (model_.parameters[static_cast<std::size_t>(each)].name == name) return each;
    }
    return -1;
  }

  const robot::RobotModel& model_;
  robot::Mounting mounting_;
  std::vector<double> q_;
  std::vector<math::Pose> X_WB_;
  std::size_t body_ = 0;
  int x_ = -1;
  int y_ = -1;
};

/// What stands on the site, seen from above and grown by the vehicle.
class PlanView {
 public:
  PlanView(const travel::Heights& heights, double radius) : heights_(heights) {
    if (radius > 0) footprint_ = travel::disc(radius);
  }

  void add(const std::string& name, const std::vector<geometry::Shape>& shapes,
           const math::Pose& X_WB) {
    travel::Obstacle obstacle;
    obstacle.name = name;
    for (const geometry::Shape& shape : shapes) {
      for (const std::vector<Vec2>& outline : travel::plan_view(shape, X_WB, heights_)) {
        add_grown(outline, obstacle.parts);
      }
    }
    if (!obstacle.parts.empty()) obstacles.push_back(std::move(obstacle));
  }

  void add(const interpreter::MovingSpec& moving) {
    const auto& places = moving.timetable.places;
    const double height = places.front().X_WO.translation().z();
    const std::size_t before = obstacles.size();
    add(moving.name, moving.shapes, math::translation(0, 0, height));
    if (obstacles.size() == before) return;
    travel::Obstacle& obstacle = obstacles.back();
    obstacle.repeat = moving.timetable.repeat;
    for (const geometry::TimedPlace& place : places) {
      const math::Pose& X = place.X_WO;
      if (X.translation().z() != height || !(X.linear()(2, 2) > 1 - kUpright)) {
        throw std::invalid_argument(fmt::format(
            "moving '{}' leans or goes up or down; --exact is for what stays upright at its height",
            moving.name));
      }
      obstacle.timetable.push_back({schedule::seconds_from_ticks(place.time),
                                    X.translation().head<2>(),
                                    math::atan2_deg(X.linear()(1, 0), X.linear()(0, 0))});
    }
  }

  std::vector<travel::Obstacle> obstacles;

 private:
  void add_grown(const std::vector<Vec2>& outline, std::vector<std::vector<Vec2>>& parts) const {
    if (footprint_.empty()) {
      parts.push_back(outline);
      return;
    }
    for (const travel::Piece& piece : travel::grown_pieces(outline, footprint_, 0)) {
      parts.push_back(travel::in_metres(piece.ring));
    }
  }

  travel::Heights heights_;
  std::vector<Vec2> footprint_;
};

std::vector<travel::Obstacle> obstacles_of(const interpreter::PlanModel& plan, int own,
                                           const travel::Heights& heights, double radius) {
  PlanView view(heights, radius);
  for (std::size_t i = 0; i < plan.site.size(); ++i) {
    view.add(site::site_shape_name(i, plan.site.size()), {plan.site[i]}, math::Pose::Identity());
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
  for (const interpreter::MovingSpec& moving : plan.movings) view.add(moving);
  return view.obstacles;
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
  const Vehicle vehicle(plan.robots[static_cast<std::size_t>(robot)]);
  TravelComparison comparison;
  comparison.plan = plan.name;
  comparison.task = task;
  comparison.radius = vehicle.radius();
  comparison.start = vehicle.place();
  comparison.destination = vehicle.place_at(*goal);
  travel::TravelQuery query;
  query.start = comparison.start;
  query.destination = comparison.destination;
  query.obstacles = obstacles_of(plan, robot, vehicle.heights(), comparison.radius);
  comparison.obstacles = query.obstacles.size();
  travel::TravelSettings own = settings;
  if (vehicle.speed() > 0) own.speed = vehicle.speed();
  comparison.movings = static_cast<std::size_t>(
      std::count_if(query.obstacles.begin(), query.obstacles.end(),
                    [](const travel::Obstacle& each) { return !each.timetable.empty(); }));
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
