#include "src/fleets/grid/stay_table.hpp"

#include <algorithm>

namespace rubicon::grid {

void StayTable::add(int agent, const CellWay& way) {
  each_stay(way, [&](CellId cell, int from, int to) {
    std::vector<Stay>& stays = stays_[static_cast<std::size_t>(cell)];
    stays.insert(stays.begin() + first_until(cell, from), {from, to, agent});
  });
}

void StayTable::remove(const CellWay& way) {
  each_stay(way, [&](CellId cell, int from, int) {
    std::vector<Stay>& stays = stays_[static_cast<std::size_t>(cell)];
    stays.erase(stays.begin() + first_until(cell, from));
  });
}

int StayTable::first_until(CellId cell, int tick) const {
  const std::vector<Stay>& stays = in(cell);
  const auto found = std::lower_bound(stays.begin(), stays.end(), tick,
                                      [](const Stay& stay, int t) { return stay.to < t; });
  return static_cast<int>(found - stays.begin());
}

int StayTable::agent_at(CellId cell, int tick) const {
  const std::vector<Stay>& stays = in(cell);
  const auto index = static_cast<std::size_t>(first_until(cell, tick));
  return index < stays.size() && stays[index].from <= tick ? stays[index].agent : -1;
}

}  // namespace rubicon::grid
