#pragma once

#include <stdexcept>
#include <string>

#include "src/motion/robot/robot_model.hpp"

namespace rubicon::test {

/// The index of the parameter that is shown under this name; throws if there is none.
inline int find_parameter(const robot::RobotModel& model, const std::string& name) {
  for (std::size_t i = 0; i < model.parameters.size(); ++i) {
    if (model.parameters[i].display_name == name) return static_cast<int>(i);
  }
  throw std::invalid_argument("the robot of this test has no parameter " + name);
}

}  // namespace rubicon::test
