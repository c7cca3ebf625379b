#pragma once

#include <optional>
#include <vector>

#include "src/motion/coverage/lines.hpp"

namespace rubicon::coverage {

/// A line in the direction it is driven.
struct DirectedLine {
  int line = 0;
  bool reversed = false;
};

/// With more lines no random changes are tried.
inline constexpr std::size_t kMostLinesForTries = 120;

struct OrderQuery {
  const std::vector<WorkLine>* lines = nullptr;  ///< those of a cell stand together
  std::size_t cell_count = 0;
  const FreeSpace* space = nullptr;
  OrderRule rule = OrderRule::kAuto;
  bool whole_cells = false;
  int tries = 0;  ///< random changes at the end
  std::optional<Point> from;
  std::optional<Point> inlet;  ///< the first cell is the one farthest from it
};

struct OrderResult {
  std::vector<int> cells;  ///< each cell that has lines once
  std::vector<DirectedLine> lines;
  int cut_off = 0;  ///< lines that no allowed way leads to from the others; they are left out
};

/// The order of cells and of lines for a short way. Cells, each driven to and fro from one of four
/// corners, are ordered by dynamic programming over sets (Held and Karp 1962) up to 12 of them,
/// else nearest next with 2-opt and or-opt among the ten nearest; then single lines by the same
/// moves, with a fixed sequence of random kicks where they are few. Distances are shortest ways.
OrderResult order_lines(const OrderQuery& query);

}  // namespace rubicon::coverage
