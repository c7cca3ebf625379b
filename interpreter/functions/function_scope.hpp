#pragma once

#include <span>

#include "interpreter/functions/way_log.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::interpreter {

/// What a function of the motion language may ask of the motion that calls it. Parameters by their
/// index in the model; metres, degrees, seconds.
class FunctionScope {
 public:
  virtual const robot::RobotModel& model() const = 0;
  virtual const robot::Mounting& mounting() const = 0;
  /// Where the robot stands, per parameter.
  virtual std::span<const double> q() const = 0;
  /// The goal configuration, per parameter, and the goal position of the tool.
  virtual std::span<const double> goal() const = 0;
  virtual const math::Vec3& p_WG() const = 0;
  /// Since the motion began.
  virtual double seconds() const = 0;
  /// From the tool to p_WG.
  virtual double distance_to_goal() const = 0;
  /// Whether `move_dir(parameter, direction)` would be accepted now.
  virtual bool would_accept(int parameter, double direction) = 0;
  /// How far the robot, as it stands, can be pushed along a horizontal heading of the world, at
  /// most the range of its sensor.
  virtual double free_distance(double heading_deg) const = 0;
  /// Whether what it would touch there first is moving.
  virtual bool is_met_moving(double heading_deg) const = 0;
  /// The way since the script began; places by their numbers, which `here` gives.
  virtual const WayLog& way() const = 0;

 protected:
  ~FunctionScope() = default;
};

}  // namespace rubicon::interpreter
