#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "src/motion/coverage/grid.hpp"

namespace rubicon::area_io {

using coverage::Point;
using coverage::Ring;

/// A straight piece of a drawing, on the grid.
struct DrawnPiece {
  Point from;
  Point to;
  std::size_t line = 0;  ///< of the file
};

/// An end where lines stop short of each other.
struct OpenEnd {
  Point at;
  std::size_t line = 0;    ///< of the file, of the piece that ends there
  bool has_other = false;  ///< whether there is another open end
  Point other;             ///< the nearest one
  std::size_t other_line = 0;
};

/// What lines enclose.
struct ClosedLines {
  std::vector<Ring> rings;    ///< the outer border of each group of lines that hang together
  std::vector<OpenEnd> open;  ///< then there may be rings missing
  int closed_gaps = 0;        ///< ends that were moved onto others or onto lines
  int overlaps = 0;           ///< pieces that were drawn twice
  bool too_tangled = false;   ///< more crossings than kMostCrossings: nothing else is said
};

/// Joins pieces to closed lines. Ends within `tolerance` (units, 1 or more) of each other become
/// one; an end within it of a line lies on the line; what goes past a line by no more ends there;
/// pieces that cross share a corner; a piece that lies on another counts once. A corner between a
/// line along x and one along y lies where the two cross. The first in the file decides among
/// equals.
ClosedLines close_lines(const std::vector<DrawnPiece>& pieces, std::int64_t tolerance);

/// Crossings of lines in a drawing, and pieces that they are cut into.
inline constexpr std::size_t kMostCrossings = 500'000;

}  // namespace rubicon::area_io
