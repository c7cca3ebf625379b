#include "src/motion/robot/robot_model.hpp"

#include <algorithm>

namespace rubicon::robot {

int RobotModel::find_body(const std::string& wanted) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].name == wanted) return static_cast<int>(i);
  }
  return -1;
}

std::vector<double> RobotModel::start_values() const {
  std::vector<double> values;
  values.reserve(parameters.size());
  for (const Parameter& parameter : parameters) values.push_back(parameter.start);
  return values;
}

double RobotModel::smallest_translation_step() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Parameter& parameter : parameters) {
    if (!parameter.rotation && parameter.step > 0) smallest = std::min(smallest, parameter.step);
  }
  return smallest < std::numeric_limits<double>::infinity() ? smallest : 1.0;
}

}  // namespace rubicon::robot
