#pragma once

#include <optional>
#include <vector>

#include "src/exchange/ifc/step_file.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::ifc {

/// An area in the plane: what is inside its outline and in none of its holes. Lines without their
/// first point at the end, either way round, z 0, in the units of the file.
struct Region {
  std::vector<math::Vec3> outline;
  std::vector<std::vector<math::Vec3>> holes;
};

/// A profile that is given by its measures: rectangle, circle, ellipse, L, U, T, C, Z, I,
/// trapezium, and hollow ones. Round corners and circles become chords; slopes of flanges are left
/// out. Nothing for other profiles, and for measures that make none.
std::optional<Region> measured_profile(const StepFile& file, const StepRecord& record,
                                       double metres_per_unit);

}  // namespace rubicon::ifc
