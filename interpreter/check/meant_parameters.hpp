#pragma once

#include <string>
#include <vector>

#include "src/motion/robot/robot_model.hpp"

namespace rubicon::interpreter {

/// The display names of those parameters that a name may mean which is ambiguous: those that a
/// command moves; where there is none, all of that name.
std::vector<std::string> meant_parameters(const robot::RobotModel& robot, const std::string& name);

}  // namespace rubicon::interpreter
