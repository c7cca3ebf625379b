#pragma once

#include <algorithm>
#include <vector>

#include "src/fleets/grid/cell_graph.hpp"

namespace rubicon::grid {

/// The cells of a vehicle from now (tick 0) to the end of a window, one a tick.
using WindowWay = std::vector<CellId>;

/// Who is in which cell at which tick of a window that moves on with time.
class WindowTable {
 public:
  WindowTable(int cells, int window)
      : cells_(at(cells)), ticks_(at(window) + 1), who_(cells_ * ticks_, -1) {}

  /// At a tick of the window, 0 to its length; -1 for nobody.
  int at_tick(int tick, CellId cell) const { return who_[row(tick) * cells_ + at(cell)]; }
  void add(int vehicle, const WindowWay& way) {
    for (std::size_t k = 0; k < way.size(); ++k) slot(k, way[k]) = vehicle;
  }
  /// Cells below 0 are left out.
  void remove(const WindowWay& way) {
    for (std::size_t k = 0; k < way.size(); ++k) {
      if (way[k] >= 0) slot(k, way[k]) = -1;
    }
  }
  void set(int tick, CellId cell, int vehicle) { slot(at(tick), cell) = vehicle; }
  /// The window begins one tick later. Its last tick is that which was its first, and must be
  /// empty.
  void move_on() { first_ = first_ + 1 == ticks_ ? 0 : first_ + 1; }

 private:
  std::size_t row(int tick) const {
    const std::size_t sum = first_ + at(tick);
    return sum < ticks_ ? sum : sum - ticks_;
  }
  int& slot(std::size_t tick, CellId cell) {
    return who_[row(static_cast<int>(tick)) * cells_ + at(cell)];
  }

  std::size_t cells_, ticks_;
  std::size_t first_ = 0;
  std::vector<int> who_;
};

}  // namespace rubicon::grid
