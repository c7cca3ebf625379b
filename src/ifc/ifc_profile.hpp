#pragma once

#include <optional>
#include <vector>

#include "src/ifc/step_file.hpp"
#include "src/math/pose.hpp"

namespace rubicon::ifc {

/// The outline of a profile that is given by its measures and that the library does not know: L, U,
/// T, C, Z, unequal I, trapezium. Counterclockwise, in the units of the file, z 0. Rounded corners
/// and slopes of flanges are left out: the outline is that of the sharp profile. Nothing for other
/// profiles, and for measures that make none.
std::optional<std::vector<math::Vec3>> profile_outline(const StepFile& file,
                                                       const StepRecord& record);

}  // namespace rubicon::ifc
