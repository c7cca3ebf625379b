#pragma once

#include <map>
#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/area_io/drawing.hpp"
#include "src/exchange/area_io/floor_areas.hpp"

namespace rubicon::area_io {

/// How the lines of a drawing become a floor.
struct DrawingTerms {
  std::string file;                           ///< for messages
  std::map<std::string, std::string> layers;  ///< outline, shafts, columns, beams: pattern of names
  double unit = 0;                            ///< m; 0: as the drawing says
  double tolerance = 0.005;                   ///< m
  double height = 0;                          ///< m
};

/// The parts of a floor that lines by layer may be: outline, shafts, columns, beams.
const std::vector<std::string>& parts_of_drawings();

/// Floors of a drawing: closed lines of the layer `outline`, one in another a shaft; of `shafts`
/// and `columns` each group of lines that hang together; each piece of `beams` a beam. Where lines
/// do not close, errors name the places and lines (I19); what was mended, and what of the drawing
/// is not read, are warnings (I19). `notes` are for the head of the plan.
std::vector<ImportedArea> floors_of_drawing(const Drawing& drawing, const DrawingTerms& terms,
                                            std::vector<std::string>& notes,
                                            interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::area_io
