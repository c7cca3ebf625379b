#pragma once

#include <span>

#include "interpreter/check/plan_model.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::taskplan {

/// Whether a robot at q is at its goal already: parameter values within a millionth of a step and
/// `within`, a frame within 1e-6 m and rad or `within`; the measure a motion's end is judged by.
bool goal_holds(const robot::RobotModel& model, const robot::Mounting& mounting,
                std::span<const double> q, const interpreter::GoalSpec& goal,
                const interpreter::Within& within, robot::FreeTurn free = robot::FreeTurn::none);

}  // namespace rubicon::taskplan
