#pragma once

#include <map>
#include <string>

#include "src/motion/robot/robot_model.hpp"

namespace rubicon::test {

/// The robots that the script checks are tried on, as their checked models: crane, agent and
/// finisher of the 1995 paper (4.1 to 4.3), a gantry on two axes, and an arm with a derived
/// parameter and no ranges.
const std::map<std::string, robot::RobotModel>& script_robots();

}  // namespace rubicon::test
