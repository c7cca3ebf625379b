#pragma once

#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/area_io/floor_areas.hpp"
#include "src/exchange/building_io/read_elements.hpp"

namespace rubicon::area_io {

struct StoreyTerms {
  std::string storey;       ///< its name, or a pattern that is right for one
  double tolerance = 0.02;  ///< m: gaps between slabs that are closed
};

/// Floors of the slabs (IfcSlab) of a storey, one for each height and each part that hangs
/// together. Openings in the slabs, and what they leave free between them, are shafts. Columns of
/// any storey that stand on the floor or through it, and walls that stand through it, are columns
/// or are cut out; beams are those just below. Elements must have been read with their meshes.
/// Errors are I19.
std::vector<ImportedArea> floors_of_storey(const building_io::Elements& elements,
                                           const StoreyTerms& terms,
                                           std::vector<std::string>& notes,
                                           interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::area_io
