#pragma once

#include <optional>
#include <vector>

#include "src/exchange/ifc/curve_points.hpp"
#include "src/exchange/ifc/solid.hpp"

namespace rubicon::ifc {

/// Whether this is IfcTriangulatedFaceSet or IfcPolygonalFaceSet.
bool is_face_list(const StepRecord& record);

/// The triangles of such a record, in the units of the file. Nothing if an index or a point is not
/// there, or a polygon cannot be split into triangles.
std::optional<Solid> solid_of_face_list(const ShapeTerms& terms, const StepRecord& record);

/// Adds the triangles of a plane face, whose outer loop is the longest; holes may run either way.
/// False if it cannot be split. A face without area is left out.
bool put_face(std::vector<Loop> loops, Solid& solid, WorkBudget& budget);

}  // namespace rubicon::ifc
