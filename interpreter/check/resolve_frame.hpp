#pragma once

#include <optional>

#include "interpreter/check/resolve_formula.hpp"
#include "src/motion/math/pose.hpp"
#include "src/motion/robot/robot_model.hpp"

namespace rubicon::interpreter {

/// A frame as a product of elementary transforms (LANGUAGE 11). Nothing after reporting F06 for a
/// wrong number of arguments, F07 for lengths beyond kMaxLength, or what resolve_formula reports.
std::optional<robot::FrameFormula> resolve_frame(const syntax::Frame& frame, FormulaNames& names,
                                                 Diagnostics& diagnostics);

/// A frame that does not move: of a shape, or in a plan. `names` may know constants; a name that
/// moves is an error (F12).
std::optional<math::Pose> resolve_constant_frame(const syntax::Frame& frame, FormulaNames& names,
                                                 Diagnostics& diagnostics);

}  // namespace rubicon::interpreter
