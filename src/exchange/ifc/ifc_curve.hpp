#pragma once

#include <optional>
#include <vector>

#include "src/exchange/ifc/step_file.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::ifc {

/// A curve as a line of points, in the units of the file.
struct PointLine {
  std::vector<math::Vec3> points;
  bool flat = false;  ///< in a plane, z is nothing
};

/// The points of an IfcIndexedPolyCurve: its lines, and its arcs as chords. Nothing if it is none,
/// or an index or a number is not there.
std::optional<PointLine> indexed_curve(const StepFile& file, const StepRecord& record,
                                       double metres_per_unit);

}  // namespace rubicon::ifc
