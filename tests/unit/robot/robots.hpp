#pragma once

#include <limits>
#include <string>
#include <vector>

#include "src/motion/robot/kinematics.hpp"

namespace rubicon::robot {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Formulas, written as one would on paper.
Formula number(double value);
Formula of(int parameter);
Formula step_of(int parameter);
Formula start_of(int parameter);
Formula operator+(const Formula& a, const Formula& b);
Formula operator-(const Formula& a, const Formula& b);
Formula operator*(const Formula& a, const Formula& b);
Formula operator/(const Formula& a, const Formula& b);
Formula operator-(const Formula& a);
Formula sin_of(const Formula& a);
Formula cos_of(const Formula& a);

FrameElement trans(const Formula& a, const Formula& b, const Formula& c);
FrameElement trans(double a, double b, double c);
FrameElement rotx(const Formula& a);
FrameElement roty(const Formula& a);
FrameElement rotz(const Formula& a);

/// Adds a body standing on `parent`; returns its index.
int add_body(RobotModel& model, const std::string& name, int parent);

/// Adds a free parameter to the last body; returns its index. A rotation is one of psi, phi, theta.
int add_parameter(RobotModel& model, const std::string& name, double lower, double upper,
                  double step);
int add_cyclic(RobotModel& model, const std::string& name, double step);

Mounting mounting_of(const RobotModel& model, const Pose& X_WM = Pose::Identity());

/// Steps of all parameters, one of them set.
std::vector<double> one_step(const RobotModel& model, int parameter, double ds);

// The robots of the reference (LANGUAGE 11).
RobotModel gantry();
RobotModel agent();     ///< x y z theta; x local
RobotModel crane();     ///< theta; x z on the hook
RobotModel finisher();  ///< base.x; z; effector.x

/// A crane whose hook turns by its own theta, with offsets everywhere and a tool off the hook.
RobotModel crane_with_turning_hook();
/// Three links of 4, 3 and 2 m turning about y, each a body.
RobotModel planar_arm();
/// Swing, boom, stick, bucket; the bucket 2 m long.
RobotModel excavator();

}  // namespace rubicon::robot
