#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "src/motion/coverage/grid.hpp"

namespace rubicon::area_io {

using coverage::Place;

/// A line of straight pieces of a drawing; arcs are chords.
struct DrawnLine {
  std::string layer;
  std::vector<Place> points;  ///< in units of the drawing
  bool closed = false;
  bool round = false;    ///< a circle: `points` are its middle alone
  double diameter = 0;   ///< of a circle
  std::size_t line = 0;  ///< of the file where it begins, from 1
};

/// A drawing in two dimensions.
struct Drawing {
  int units = 0;                 ///< $INSUNITS; 0: it says none
  std::vector<DrawnLine> lines;  ///< in the order of the file
  /// What there is besides, by kind and layer, and how much: blocks, texts, what is of a sheet.
  std::map<std::pair<std::string, std::string>, int> unread;
};

/// Why a text is no drawing.
struct DrawingError {
  std::size_t line = 0;  ///< from 1; 0: the whole
  std::string message;   ///< lower case, for people
};

/// Reads an ASCII DXF file (AutoCAD DXF reference, R12 to 2018): LINE, LWPOLYLINE, POLYLINE,
/// CIRCLE, ARC of the model space. Heights are left out. The text is not trusted: reading takes
/// time and memory in proportion to it.
std::variant<Drawing, DrawingError> read_dxf(std::string_view text);

/// Metres in a unit of $INSUNITS; 0 for 0 and for units that are not lengths of buildings.
double metres_in(int insunits);
/// "mm", "m"; "" where metres_in is 0.
std::string unit_name(int insunits);

/// A drawing has up to so many points.
inline constexpr std::size_t kMostDrawnPoints = 1'000'000;

}  // namespace rubicon::area_io
