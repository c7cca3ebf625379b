#include "src/fleets/grid/keep_order.hpp"

namespace rubicon::grid {

bool KeepOrder::goes(int vehicle) {
  Move& move = moves_[at(vehicle)];
  // Asked again on its own behalf: a ring in which each goes where the next one leaves.
  if (move == Move::asked || move == Move::goes) return true;
  if (move == Move::stays) return false;
  move = Move::stays;
  const std::vector<CellId>& cells = cells_[at(vehicle)];
  const int next = place_[at(vehicle)] + 1;
  if (may_[at(vehicle)] == 0 || at(next) == cells.size()) return false;
  const CellId cell = cells[at(next)];
  const Turn& turn = order_[at(cell)][at(passed_[at(cell)])];
  if (turn.vehicle != vehicle || turn.place != next) return false;
  move = Move::asked;
  if (who_[at(cell)] >= 0 && !goes(who_[at(cell)])) {
    moves_[at(vehicle)] = Move::stays;
    return false;
  }
  moves_[at(vehicle)] = Move::goes;
  return true;
}

void KeepOrder::retime(std::vector<WindowWay>& ways, const std::vector<int>& done,
                       const std::vector<int>& ready, int ticks) {
  const std::size_t count = ways.size();
  cells_.resize(count);
  place_.assign(count, 0);
  may_.assign(count, 0);
  by_tick_.resize(count == 0 ? 0 : ways.front().size());
  for (auto& turns : by_tick_) turns.clear();
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<CellId>& cells = cells_[i];
    cells.clear();
    for (std::size_t k = at(done[i]); k < ways[i].size(); ++k) {
      if (!cells.empty() && cells.back() == ways[i][k]) continue;
      by_tick_[k].push_back({static_cast<int>(i), static_cast<int>(cells.size())});
      cells.push_back(ways[i][k]);
    }
  }
  for (const CellId cell : touched_) {
    order_[at(cell)].clear();
    passed_[at(cell)] = 0;
    who_[at(cell)] = -1;
  }
  touched_.clear();
  for (const auto& turns : by_tick_) {
    for (const Turn& turn : turns) {
      const CellId cell = cells_[at(turn.vehicle)][at(turn.place)];
      if (order_[at(cell)].empty()) touched_.push_back(cell);
      order_[at(cell)].push_back(turn);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const CellId cell = cells_[i].front();
    who_[at(cell)] = static_cast<int>(i);
    passed_[at(cell)] = 1;
    ways[i].assign(at(ticks) + 1, cell);
  }
  for (int tick = 1; tick <= ticks; ++tick) {
    moves_.assign(count, Move::unknown);
    for (std::size_t i = 0; i < count; ++i) may_[i] = ready[i] < tick ? 1 : 0;
    for (std::size_t i = 0; i < count; ++i) goes(static_cast<int>(i));
    for (std::size_t i = 0; i < count; ++i) {
      if (moves_[i] != Move::goes) continue;
      int& here = who_[at(cells_[i][at(place_[i])])];
      if (here == static_cast<int>(i)) here = -1;
      const CellId next = cells_[i][at(++place_[i])];
      who_[at(next)] = static_cast<int>(i);
      ++passed_[at(next)];
    }
    for (std::size_t i = 0; i < count; ++i) ways[i][at(tick)] = cells_[i][at(place_[i])];
  }
}

}  // namespace rubicon::grid
