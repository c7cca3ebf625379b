#pragma once

#include <string>

#include "src/motion/robot/robot_model.hpp"

namespace rubicon::trace {

/// A transform function in the language's own notation: parameters by display name, steps with
/// `_s`, start values with `_c` behind it; angles in degrees.
std::string formula_text(const robot::RobotModel& model, const robot::Formula& formula);

/// A frame as robot files write it: trans(x, 0, z) * rotz(theta). The identity is trans(0, 0, 0).
std::string frame_text(const robot::RobotModel& model, const robot::FrameFormula& frame);

}  // namespace rubicon::trace
