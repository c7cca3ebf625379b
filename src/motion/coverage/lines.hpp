#pragma once

#include <vector>

#include "src/motion/coverage/cells.hpp"
#include "src/motion/coverage/free_space.hpp"

namespace rubicon::coverage {

/// A way of the tool at work, driven in either direction.
struct WorkLine {
  std::vector<Point> points;  ///< 2 or more, different
  int cell = 0;
  bool is_pass = false;  ///< along a border or a hole; else a line along x
};

/// The lines of all cells. Each cell gets as few lines along x as the width allows, evenly spaced,
/// half a spacing from its bottom and top; where a grown obstacle is in the way a line is cut. What
/// such cuts and slanted borders leave out is worked by passes: beside an obstacle across the
/// lines, which then end where the pass has worked; over and under it; along slanted borders.
/// Lines of a cell stand together, bottom up and along x, its passes after them.
std::vector<WorkLine> lines_of(const std::vector<Cell>& cells, const Ring& outline,
                               const FreeSpace& space, std::int64_t width);

/// How many lines along x the cells have, obstacles left out of account.
std::int64_t count_lines(const std::vector<Cell>& cells, std::int64_t width);

}  // namespace rubicon::coverage
