#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "src/fleets/grid/cell_graph.hpp"

namespace rubicon::grid {

/// The cells of one agent, tick by tick from 0; it stays in the last one for good.
using CellWay = std::vector<CellId>;
/// After all ticks; one tick more can still be said.
inline constexpr int kForGood = std::numeric_limits<int>::max() - 1;

/// An agent is in a cell from one tick to another, both included.
struct Stay {
  int from = 0;
  int to = 0;
  int agent = -1;
};

/// Who is where and when. In each cell the stays are apart from each other and in the order of
/// time.
class StayTable {
 public:
  explicit StayTable(int cells) : stays_(static_cast<std::size_t>(cells)) {}

  void add(int agent, const CellWay& way);
  void remove(const CellWay& way);
  const std::vector<Stay>& in(CellId cell) const { return stays_[static_cast<std::size_t>(cell)]; }
  /// The first stay in `cell` that ends at `tick` or later, as an index.
  int first_until(CellId cell, int tick) const;
  /// Who is in `cell` at `tick`; -1 for nobody.
  int agent_at(CellId cell, int tick) const;

 private:
  std::vector<std::vector<Stay>> stays_;
};

/// Calls `take(cell, from, to)` for each stay of a way.
template <typename Take>
void each_stay(const CellWay& way, const Take& take) {
  int from = 0;
  const int end = static_cast<int>(way.size());
  for (int tick = 1; tick <= end; ++tick) {
    const CellId cell = way[static_cast<std::size_t>(from)];
    if (tick < end && way[static_cast<std::size_t>(tick)] == cell) continue;
    take(cell, from, tick == end ? kForGood : tick - 1);
    from = tick;
  }
}

}  // namespace rubicon::grid
