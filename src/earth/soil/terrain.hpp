#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "src/earth/soil/heights.hpp"

namespace rubicon::soil {

using CubicMillimetres = std::int64_t;

/// The most cells of a terrain, and its largest height either way.
inline constexpr int kMostCells = 250'000;
inline constexpr Millimetres kMostHeight = 10'000'000;

/// The ground as a height field of square cells. Frame {E}: x along the columns, y along the rows,
/// the origin at the outer corner of the first cell, z up. Each cell is a column of soil with a
/// flat top; heights are whole mm, so that each volume is whole mm3.
struct Terrain {
  int columns = 0, rows = 0;
  Millimetres cell = 0;  ///< the side of a cell
  Heights heights;       ///< row by row

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// Of the middle of a cell, m.
  double middle(int column_or_row) const {
    return (static_cast<double>(column_or_row) + 0.5) * static_cast<double>(cell) * 1e-3;
  }
};

Terrain flat(int columns, int rows, Millimetres cell, Millimetres height);

/// Heights (m) as text: one row of cells a line, the first line the row farthest from the origin
/// (as a map is drawn, north up), numbers separated by commas, semicolons, blanks or tabs; a line
/// that is empty or begins with # is skipped. A message for users, with the line, if these are not
/// rows x columns numbers.
std::variant<Terrain, std::string> terrain_of(std::string_view text, int columns, int rows,
                                              Millimetres cell);

}  // namespace rubicon::soil
