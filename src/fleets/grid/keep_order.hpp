#pragma once

#include <vector>

#include "src/fleets/grid/window_table.hpp"

namespace rubicon::grid {

/// Works out times again, in the order in which vehicles come to each cell.
class KeepOrder {
 public:
  explicit KeepOrder(int cells) : order_(at(cells)), passed_(at(cells), 0), who_(at(cells), -1) {}

  /// `ways` were planned from some tick on; since then each vehicle has come to place `done[i]` of
  /// its way, which may be behind the plan. From now on vehicle `i` stands for `ready[i]` ticks and
  /// then goes on as soon as all that come before it to its next cell have left it. The new ways
  /// begin now, have `ticks` + 1 cells, and are free of conflicts as the old ones were: where they
  /// say that somebody comes to a cell after another it still does, and whoever follows another
  /// into a cell in one tick may still do so, also around a ring.
  void retime(std::vector<WindowWay>& ways, const std::vector<int>& done,
              const std::vector<int>& ready, int ticks);

 private:
  struct Turn {
    int vehicle = -1;
    int place = 0;
  };
  /// What is known of one vehicle within one tick.
  enum class Move : char { unknown, asked, goes, stays };

  bool goes(int vehicle);

  std::vector<std::vector<Turn>> order_;  ///< by cell, in the order of the plan
  std::vector<int> passed_;               ///< by cell: of its order, who has come
  std::vector<int> who_;                  ///< by cell: who is there, -1 for nobody
  std::vector<CellId> touched_;
  std::vector<std::vector<Turn>> by_tick_;
  std::vector<std::vector<CellId>> cells_;  ///< by vehicle: the cells it comes to, each once
  std::vector<int> place_;                  ///< by vehicle: where it is in `cells_`
  std::vector<char> may_;                   ///< by vehicle: it does not stand
  std::vector<Move> moves_;
};

}  // namespace rubicon::grid
