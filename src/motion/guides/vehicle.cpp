#include "src/motion/guides/vehicle.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/guides/leg.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::guides {

using math::at;
using travel::Vec2;

Vehicle::Vehicle(const robot::RobotModel& model, const robot::Mounting& mounting)
    : model_(model), mounting_(mounting) {
  for (std::size_t body = 0; body < model_.bodies.size() && y_ < 0; ++body) {
    x_ = parameter_of(body, "x");
    y_ = x_ < 0 ? -1 : parameter_of(body, "y");
    body_ = body;
  }
}

int Vehicle::parameter_of(std::size_t body, const char* name) const {
  for (const int each : model_.bodies[body].parameters) {
    if (model_.parameters[at(each)].name == name) return each;
  }
  return -1;
}

std::vector<math::Pose> Vehicle::poses(std::span<const double> q) const {
  std::vector<double> all(q.begin(), q.end());
  robot::update_derived(model_, mounting_, all);
  std::vector<math::Pose> X_WB;
  robot::body_poses(model_, mounting_, all, X_WB);
  return X_WB;
}

Vec2 Vehicle::place(std::span<const double> q) const {
  return poses(q)[body_].translation().head<2>();
}

void Vehicle::set_place(const Vec2& p, std::vector<double>& q) const {
  std::vector<double> moved = q;
  moved[at(x_)] = moved[at(y_)] = 0;
  const Vec2 origin = place(moved);
  moved[at(x_)] = 1;
  const Vec2 along_x = place(moved) - origin;
  moved[at(x_)] = 0;
  moved[at(y_)] = 1;
  const Vec2 along_y = place(moved) - origin;
  const double turns = along_x.x() * along_y.y() - along_x.y() * along_y.x();
  if (turns == 0) return;
  const Vec2 to = p - origin;
  q[at(x_)] = (to.x() * along_y.y() - to.y() * along_y.x()) / turns;
  q[at(y_)] = (along_x.x() * to.y() - along_x.y() * to.x()) / turns;
}

double Vehicle::radius(std::span<const double> q) const {
  const std::vector<math::Pose> X_WB = poses(q);
  const Vec2 axis = X_WB[body_].translation().head<2>();
  double radius = 0;
  for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
    radius = std::max(radius, travel::reach_about(axis, model_.bodies[i].shapes, X_WB[i]));
  }
  return radius;
}

double Vehicle::width_across(const Vec2& direction, std::span<const double> q) const {
  const std::vector<math::Pose> X_WB = poses(q);
  const Vec2 across(-direction.y(), direction.x());
  travel::Heights all{HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
    const travel::Heights each = travel::extent_along(across, model_.bodies[i].shapes, X_WB[i]);
    all.low = std::min(all.low, each.low);
    all.high = std::max(all.high, each.high);
  }
  return std::max(all.high - all.low, 0.0);
}

travel::Heights Vehicle::heights(std::span<const double> q) const {
  const std::vector<math::Pose> X_WB = poses(q);
  travel::Heights all{HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
    const travel::Heights each = travel::heights_of(model_.bodies[i].shapes, X_WB[i]);
    all.low = std::min(all.low, each.low);
    all.high = std::max(all.high, each.high);
  }
  return all.low < all.high ? all : travel::Heights{-HUGE_VAL, HUGE_VAL};
}

std::vector<std::pair<int, double>> values_at(const robot::RobotModel& model,
                                              const robot::Mounting& mounting,
                                              std::span<const double> q, const math::Pose& X_W) {
  const Vehicle vehicle(model, mounting);
  const Leg leg(model, mounting);
  std::vector<double> stands(q.begin(), q.end());
  std::vector<int> moved = {vehicle.x(), vehicle.y()};
  if (leg.heading() >= 0) {
    const Eigen::Vector2d ahead = X_W.linear().col(0).head<2>();
    moved.push_back(leg.heading());
    stands[at(leg.heading())] =
        robot::reduced(model.parameters[at(leg.heading())], leg.heading_along(q, ahead));
  }
  vehicle.set_place(X_W.translation().head<2>(), stands);
  std::vector<std::pair<int, double>> values;
  for (const int parameter : moved) values.emplace_back(parameter, stands[at(parameter)]);
  return values;
}

}  // namespace rubicon::guides
