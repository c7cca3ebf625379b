#pragma once

#include <cstdint>
#include <optional>

#include "src/exchange/ifc/curve_points.hpp"
#include "src/exchange/ifc/solid.hpp"

namespace rubicon::ifc {

/// Whether this is a body or surface given face by face: IfcFacetedBrep (also with voids),
/// IfcShellBasedSurfaceModel, IfcFaceBasedSurfaceModel, IfcTriangulatedFaceSet,
/// IfcPolygonalFaceSet.
bool is_faces(const StepRecord& record);

/// The triangles of such a record, in the units of the file. Shells that are closed look outwards,
/// voids inwards. Nothing if a face cannot be read or split into triangles.
std::optional<Solid> solid_of_faces(const ShapeTerms& terms, const StepRecord& record);

}  // namespace rubicon::ifc
