#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/motion/robot/robot_model.hpp"

namespace rubicon::trace {

/// The transform function that formula_text wrote; `parameters` are the display names of the robot,
/// in its order. Throws std::invalid_argument, with a message for the user, for what is none.
robot::Formula read_formula(std::string_view text, const std::vector<std::string>& parameters);

/// The frame that frame_text wrote. Throws as read_formula.
robot::FrameFormula read_frame(std::string_view text, const std::vector<std::string>& parameters);

}  // namespace rubicon::trace
