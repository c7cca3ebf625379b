#pragma once

#include <span>
#include <utility>
#include <vector>

#include "src/motion/robot/kinematics.hpp"
#include "src/motion/travel/plan_view.hpp"

namespace rubicon::guides {

/// A machine that travels, seen from above (world, m): a body of it has parameters x and y, which
/// move its place. The model must outlive it.
class Vehicle {
 public:
  Vehicle(const robot::RobotModel& model, const robot::Mounting& mounting);

  /// Whether a body of it has parameters x and y; the rest is of such machines only.
  bool travels() const { return y_ >= 0; }
  int x() const { return x_; }
  int y() const { return y_; }

  /// Where its place is.
  travel::Vec2 place(std::span<const double> q) const;
  /// Its parameters x and y where its place is at p, all others as in q. Nothing changes where x
  /// and y do not move it over the plane.
  void set_place(const travel::Vec2& p, std::vector<double>& q) const;
  /// Of the disc about its place that holds all its bodies, however it is turned about it.
  double radius(std::span<const double> q) const;
  /// Between its sides (m), as it drives along a direction of the plan (unit vector).
  double width_across(const travel::Vec2& direction, std::span<const double> q) const;
  /// That its bodies take up; of a machine without a shape all.
  travel::Heights heights(std::span<const double> q) const;

 private:
  std::vector<math::Pose> poses(std::span<const double> q) const;
  int parameter_of(std::size_t body, const char* name) const;

  const robot::RobotModel& model_;
  robot::Mounting mounting_;
  std::size_t body_ = 0;
  int x_ = -1;
  int y_ = -1;
};

/// The parameters that bring such a machine to a pose in the plan view (world), all others as in q:
/// x and y, and the heading of one that drives along it.
std::vector<std::pair<int, double>> values_at(const robot::RobotModel& model,
                                              const robot::Mounting& mounting,
                                              std::span<const double> q, const math::Pose& X_W);

}  // namespace rubicon::guides
