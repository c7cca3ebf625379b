#include "src/fleets/grid/distances.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "src/fleets/grid/grid_problem.hpp"

namespace rubicon::grid {

Distances::Distances(const CellGraph& graph, std::vector<CellId> goals)
    : graph_(graph),
      cells_(static_cast<std::size_t>(graph.size())),
      table_(goals.size() * cells_, kUnknown),
      border_(goals.size()),
      seen_(goals.size()) {
  std::iota(seen_.begin(), seen_.end(), 0);
  for (std::size_t i = 0; i < goals.size(); ++i) {
    table_[i * cells_ + static_cast<std::size_t>(goals[i])] = 0;
    border_[i] = {goals[i]};
  }
}

void Distances::set_goal(int goal, CellId cell) {
  const auto row =
      table_.begin() + static_cast<std::ptrdiff_t>(goal) * static_cast<std::ptrdiff_t>(cells_);
  std::fill(row, row + static_cast<std::ptrdiff_t>(cells_), kUnknown);
  row[cell] = 0;
  border_[static_cast<std::size_t>(goal)] = {cell};
}

int Distances::search(int goal, CellId cell) {
  std::uint16_t* const table = table_.data() + static_cast<std::size_t>(goal) * cells_;
  std::vector<CellId>& border = border_[static_cast<std::size_t>(goal)];
  while (table[cell] == kUnknown && !border.empty()) {
    next_.clear();
    // Beyond the longest way all is as far as that: the ways there are not told apart.
    const int step = std::min(table[border.front()] + 1, kLongestWay);
    for (const CellId at : border) {
      for (const CellId beside : graph_.beside(at)) {
        if (table[beside] != kUnknown) continue;
        table[beside] = static_cast<std::uint16_t>(step);
        next_.push_back(beside);
      }
    }
    border.swap(next_);
  }
  return table[cell];
}

}  // namespace rubicon::grid
