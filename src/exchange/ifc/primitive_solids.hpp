#pragma once

#include <optional>

#include "src/exchange/ifc/solid.hpp"
#include "src/exchange/ifc/step_file.hpp"

namespace rubicon::ifc {

/// An IfcBlock, IfcRectangularPyramid, IfcRightCircularCylinder, IfcRightCircularCone or IfcSphere
/// in the units of the file; round ones in chords. Nothing for other records, and for measures that
/// make no body.
std::optional<Solid> primitive_solid(const StepFile& file, const StepRecord& record,
                                     double metres_per_unit, WorkBudget& budget);

}  // namespace rubicon::ifc
