#include "src/fleets/grid/earliest_way.hpp"

#include <algorithm>
#include <functional>

namespace rubicon::grid {

namespace {

/// A search gives up after so many expansions, and so many more for each step to the goal. Those
/// that take more look at much of the map at many times, because others close the goal in: there is
/// more to gain elsewhere.
constexpr std::int64_t kLeastWork = 500;
constexpr std::int64_t kWorkPerStep = 20;

}  // namespace

EarliestWay::EarliestWay(const CellGraph& graph, Distances& distances, const StayTable& stays)
    : graph_(graph), distances_(distances), stays_(stays), marks_(at(graph.size())) {}

int EarliestWay::gap_begin(CellId cell, int gap) const {
  return gap == 0 ? 0 : stays_.in(cell)[at(gap - 1)].to + 1;
}

int EarliestWay::gap_end(CellId cell, int gap) const {
  const auto& stays = stays_.in(cell);
  return at(gap) == stays.size() ? kForGood : stays[at(gap)].from - 1;
}

bool EarliestWay::find(int agent, CellId start, CellId goal, int latest, CellWay& way) {
  if (++search_ == 0) {  // the numbers begin again
    for (auto& marks : marks_) marks.clear();
    search_ = 1;
  }
  visits_.clear();
  open_.clear();
  if (!stays_.in(start).empty() && stays_.in(start).front().from == 0) return false;
  // It arrives when all others have gone through its goal, at the soonest.
  soonest_ = 0;
  if (!stays_.in(goal).empty()) {
    if (stays_.in(goal).back().to == kForGood) return false;
    soonest_ = stays_.in(goal).back().to + 1;
  }
  reach(start, 0, 0, -1, agent, latest);
  const std::int64_t last = expansions_ + kLeastWork + kWorkPerStep * distances_.of(agent, start);
  while (!open_.empty() && expansions_ < last) {
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    const int index = open_.back().visit;
    open_.pop_back();
    const Visit& visit = visits_[at(index)];
    if (marks_[at(visit.cell)][at(visit.gap)].tick < visit.tick) continue;
    if (visit.cell == goal && gap_end(goal, visit.gap) == kForGood) {
      way.assign(at(visit.tick) + 1, goal);
      int until = visit.tick;
      for (int i = index; i >= 0; i = visits_[at(i)].parent) {
        const Visit& each = visits_[at(i)];
        for (int tick = each.tick; tick < until; ++tick) way[at(tick)] = each.cell;
        until = each.tick;
      }
      return true;
    }
    expand(index, agent, latest);
  }
  return false;
}

void EarliestWay::expand(int index, int agent, int latest) {
  ++expansions_;
  const Visit visit = visits_[at(index)];
  const int leaves_by = gap_end(visit.cell, visit.gap);
  for (const CellId beside : graph_.beside(visit.cell)) {
    const int last_gap = static_cast<int>(stays_.in(beside).size());
    for (int gap = stays_.first_until(beside, visit.tick + 1); gap <= last_gap; ++gap) {
      const int begin = gap_begin(beside, gap);
      if (begin - 1 > leaves_by) break;
      const int tick = std::max(visit.tick + 1, begin);
      if (tick > gap_end(beside, gap)) continue;
      if (tick > begin || tick - 1 < leaves_by || !swaps(visit.cell, beside, tick)) {
        reach(beside, gap, tick, index, agent, latest);
      }
    }
  }
}

/// Whether who leaves `beside` for `tick` comes to `here`.
bool EarliestWay::swaps(CellId here, CellId beside, int tick) const {
  const int other = stays_.agent_at(here, tick);
  return other >= 0 && stays_.agent_at(beside, tick - 1) == other;
}

void EarliestWay::reach(CellId cell, int gap, int tick, int parent, int agent, int latest) {
  const int distance = distances_.of(agent, cell);
  const int arrival = std::max(tick + distance, soonest_);
  if (arrival > latest) return;
  auto& marks = marks_[at(cell)];
  if (marks.size() <= at(gap)) marks.resize(stays_.in(cell).size() + 1);
  Mark& mark = marks[at(gap)];
  if (mark.search == search_ && mark.tick <= tick) return;
  mark = {search_, tick};
  open_.push_back({arrival, distance, static_cast<int>(visits_.size())});
  std::push_heap(open_.begin(), open_.end(), std::greater<>());
  visits_.push_back({cell, gap, tick, parent});
}

}  // namespace rubicon::grid
