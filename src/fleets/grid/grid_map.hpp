#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rubicon::grid {

/// Most cells of a map, walls included.
inline constexpr std::int64_t kMostCells = 4'000'000;

/// A place on a map: column from the left, row from the top, both from 0.
struct Cell {
  int x = 0;
  int y = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// Cells in columns and rows, each open or a wall.
struct GridMap {
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> open;  ///< row by row

  bool has(Cell cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.x < columns && cell.y < rows;
  }
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(cell.x);
  }
  bool is_open(Cell cell) const { return has(cell) && open[index(cell)] != 0; }
};

/// Where a text is wrong, in bytes from its beginning, and how.
struct TextFault {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string message;
  std::string hint = {};
};

/// A map in the format of the MovingAI benchmarks: `type octile`, `height`, `width`, `map`, and the
/// rows. '.', 'G' and 'S' are open; '@', 'O', 'T' and 'W' are not.
std::variant<GridMap, TextFault> read_map(std::string_view text);

/// One line of a scenario.
struct Trip {
  Cell from;
  Cell to;
  std::size_t begin = 0;  ///< of its line in the text
  std::size_t end = 0;
};
/// A scenario of the MovingAI benchmarks, for a map of this size. At most `most` trips are read.
std::variant<std::vector<Trip>, TextFault> read_scenario(std::string_view text, const GridMap& map,
                                                         std::size_t most);

}  // namespace rubicon::grid
