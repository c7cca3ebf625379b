#pragma once

#include <string>
#include <vector>

#include "src/motion/robot/kinematics.hpp"
#include "src/simulation/trace/header.hpp"

namespace rubicon::replay {

/// A robot of a trace's header: its kinematics, and where it is mounted. `src/motion/robot` gives
/// its poses. Of the model there is what poses and steps need: no ranges, and rules as formulas.
struct Machine {
  std::string name;
  robot::RobotModel model;
  robot::Mounting mounting;
};

/// Throws std::invalid_argument, with a message for the user, for formulas that are none.
Machine make_machine(const trace::HeaderRobot& header);

/// The values a machine starts with (m or degrees): derived ones computed, angles within half a
/// turn.
std::vector<double> start_values(const Machine& machine);

}  // namespace rubicon::replay
