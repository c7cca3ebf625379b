#include "src/fleets/grid/window_search.hpp"

#include <algorithm>
#include <functional>

namespace rubicon::grid {

namespace {

/// Visits of one search at most. A search that takes more looks at all that is around a vehicle
/// which others have shut in: there is more to gain elsewhere.
constexpr std::size_t kMostVisits = 8'000;
/// Places of the hash table, a power of 2 and well above.
constexpr std::size_t kMarks = 32'768;

}  // namespace

int cost_of(const WindowWay& way, const Legs& legs, Distances& distances) {
  int leg = legs.first;
  for (std::size_t k = 0; k < way.size(); ++k) {
    leg = legs.after(leg, way[k]);
    if (leg == legs.last) return static_cast<int>(k);
  }
  return static_cast<int>(way.size()) - 1 + legs.left(distances, leg, way.back());
}

WindowSearch::WindowSearch(const CellGraph& graph, Distances& distances, const WindowTable& table,
                           int window)
    : graph_(graph), distances_(distances), table_(table), window_(window), marks_(kMarks) {}

bool WindowSearch::is_new(CellId cell, int tick, int leg) {
  std::uint64_t hash = (static_cast<std::uint64_t>(cell) * 0x9E3779B97F4A7C15U) ^
                       (static_cast<std::uint64_t>(tick * 4 + leg) * 0xBF58476D1CE4E5B9U);
  hash ^= hash >> 32U;
  for (std::size_t i = hash % kMarks;; i = (i + 1) % kMarks) {
    Mark& mark = marks_[i];
    if (mark.search != search_) {
      mark = {search_, cell, tick, leg};
      return true;
    }
    if (mark.cell == cell && mark.tick == tick && mark.leg == leg) return false;
  }
}

void WindowSearch::reach(CellId cell, int tick, int leg, int cost, int parent,
                         std::uint32_t chance) {
  if (visits_.size() >= kMostVisits || !is_new(cell, tick, leg)) return;
  open_.push_back({cost, tick, chance, static_cast<int>(visits_.size())});
  std::push_heap(open_.begin(), open_.end(), std::greater<>());
  visits_.push_back({cell, tick, leg, cost, parent});
}

bool WindowSearch::find(CellId start, int ready, const Legs& legs, RandomBits& random,
                        WindowWay& way) {
  if (++search_ == 0) {  // the numbers begin again
    std::fill(marks_.begin(), marks_.end(), Mark{});
    search_ = 1;
  }
  visits_.clear();
  open_.clear();
  // The cost of who has been at all its places is the tick at which it was.
  const auto cost = [&](CellId cell, int tick, int leg) {
    return tick + legs.left(distances_, leg, cell);
  };
  const int first = legs.after(legs.first, start);
  reach(start, std::min(ready, window_), first,
        first == legs.last ? 0 : cost(start, std::min(ready, window_), first), -1, 0);
  while (!open_.empty() && visits_.size() < kMostVisits) {
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    const int index = open_.back().visit;
    open_.pop_back();
    const Visit here = visits_[at(index)];
    if (here.tick == window_) {
      way.assign(at(window_) + 1, start);
      for (int i = index; i >= 0; i = visits_[at(i)].parent) {
        way[at(visits_[at(i)].tick)] = visits_[at(i)].cell;
      }
      return true;
    }
    ++expansions_;
    const int tick = here.tick + 1;
    const auto go = [&](CellId cell) {
      if (table_.at_tick(tick, cell) >= 0) return;
      const int other = table_.at_tick(here.tick, cell);
      if (other >= 0 && table_.at_tick(tick, here.cell) == other) return;
      const int leg = legs.after(here.leg, cell);
      // Who is done need not move, and had better not.
      const bool is_done = here.leg == legs.last;
      const auto chance = static_cast<std::uint32_t>(random.next() >> 32U);
      reach(cell, tick, leg, is_done ? here.cost : cost(cell, tick, leg), index,
            is_done && cell == here.cell ? 0 : chance);
    };
    go(here.cell);
    for (const CellId beside : graph_.beside(here.cell)) go(beside);
  }
  return false;
}

}  // namespace rubicon::grid
