#pragma once

#include <optional>

#include "src/exchange/ifc/step_file.hpp"

namespace rubicon::ifc {

/// Metres that one unit of length of the file stands for: SI with any prefix, or a unit derived
/// from one (feet, inches). Nothing if the file names none, or one that is no length above zero.
std::optional<double> metres_per_unit(const StepFile& file);

/// Radians that one unit of angle of the file stands for; 1 if it names none.
double radians_per_unit(const StepFile& file);

}  // namespace rubicon::ifc
