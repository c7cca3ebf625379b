#include "src/fleets/grid/next_moves.hpp"

#include <algorithm>
#include <utility>

namespace rubicon::grid {

NextMoves::NextMoves(const CellGraph& graph, Distances& distances, std::vector<CellId> goals)
    : graph_(graph),
      distances_(distances),
      goals_(std::move(goals)),
      now_(at(graph.size()), -1),
      next_(at(graph.size()), -1) {}

bool NextMoves::find(const Configuration& from, Configuration& to, const std::vector<int>& order,
                     RandomBits& random) {
  for (std::size_t i = 0; i < from.size(); ++i) now(from[i]) = static_cast<int>(i);
  bool found = take_moves_given(from, to);
  for (std::size_t i = 0; found && i < order.size(); ++i) {
    if (to[at(order[i])] == kNowhere) found = seek(order[i], from, to, random);
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    now(from[i]) = -1;
    if (to[i] != kNowhere) next(to[i]) = -1;
  }
  return found;
}

bool NextMoves::take_moves_given(const Configuration& from, const Configuration& to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (to[i] == kNowhere) continue;
    if (next(to[i]) >= 0) return false;
    const int other = now(to[i]);
    if (other >= 0 && other != static_cast<int>(i) && to[at(other)] == from[i]) return false;
    next(to[i]) = static_cast<int>(i);
  }
  return true;
}

NextMoves::Seeker NextMoves::seeker(int agent, const Configuration& from, const Configuration& to,
                                    RandomBits& random) {
  ++expansions_;
  Seeker result;
  result.agent = agent;
  const CellId here = from[at(agent)];
  // By distance, then by chance.
  std::array<std::uint64_t, 5> keys = {};
  std::uint64_t bits = random.next();
  const auto add = [&](CellId cell) {
    const std::uint64_t key =
        (static_cast<std::uint64_t>(distances_.of(agent, cell)) << 12U) | (bits & 0xFFFU);
    bits >>= 12U;
    int place = result.count++;
    for (; place > 0 && keys[at(place - 1)] > key; --place) {
      keys[at(place)] = keys[at(place - 1)];
      result.candidates[at(place)] = result.candidates[at(place - 1)];
    }
    keys[at(place)] = key;
    result.candidates[at(place)] = cell;
  };
  add(here);
  for (const CellId beside : graph_.beside(here)) add(beside);
  result.swaps_with = swap_partner(agent, result.candidates[0], from, to);
  if (result.swaps_with >= 0) {
    std::reverse(result.candidates.begin(), result.candidates.begin() + result.count);
  }
  return result;
}

bool NextMoves::seek(int agent, const Configuration& from, Configuration& to, RandomBits& random) {
  seekers_.clear();
  seekers_.push_back(seeker(agent, from, to, random));
  // Whether the one who was asked to go first has found a cell; nothing: nobody was asked.
  enum class Answer { none, yes, no } answer = Answer::none;
  while (!seekers_.empty()) {
    Seeker& seeking = seekers_.back();
    const CellId here = from[at(seeking.agent)];
    bool settled = answer == Answer::yes;
    answer = Answer::none;
    int asks = -1;
    while (!settled && asks < 0 && seeking.tried < seeking.count) {
      const CellId cell = seeking.candidates[at(seeking.tried++)];
      if (next(cell) >= 0) continue;
      const int other = now(cell);
      if (other >= 0 && to[at(other)] == here && other != seeking.agent) continue;
      next(cell) = seeking.agent;
      to[at(seeking.agent)] = cell;
      if (other >= 0 && other != seeking.agent && to[at(other)] == kNowhere) {
        asks = other;
      } else {
        settled = true;
      }
    }
    if (asks >= 0) {
      seekers_.push_back(seeker(asks, from, to, random));
      continue;
    }
    if (settled) {
      const int partner = seeking.swaps_with;
      if (seeking.tried == 1 && partner >= 0 && to[at(partner)] == kNowhere && next(here) < 0) {
        to[at(partner)] = here;
        next(here) = partner;
      }
      answer = Answer::yes;
    } else {
      // It stays, so whoever wanted its cell has to look for another.
      next(here) = seeking.agent;
      to[at(seeking.agent)] = here;
      answer = Answer::no;
    }
    seekers_.pop_back();
  }
  return answer == Answer::yes;
}

NextMoves::WaysOn NextMoves::ways_on(CellId cell, CellId behind) const {
  WaysOn ways;
  for (const CellId beside : graph_.beside(cell)) {
    if (beside == behind) continue;
    const int agent = now_[static_cast<std::size_t>(beside)];
    const bool is_taken =
        graph_.beside(beside).size() == 1 && agent >= 0 && goals_[at(agent)] == beside;
    if (is_taken) continue;
    ++ways.count;
    ways.last = beside;
  }
  return ways;
}

bool NextMoves::must_swap(int pusher, int puller, CellId pusher_at, CellId puller_at) {
  while (distances_.of(pusher, puller_at) < distances_.of(pusher, pusher_at)) {
    const WaysOn ways = ways_on(puller_at, pusher_at);
    if (ways.count >= 2) return false;
    if (ways.count == 0) break;
    pusher_at = std::exchange(puller_at, ways.last);
  }
  return distances_.of(puller, pusher_at) < distances_.of(puller, puller_at) &&
         (distances_.of(pusher, pusher_at) == 0 ||
          distances_.of(pusher, puller_at) < distances_.of(pusher, pusher_at));
}

bool NextMoves::can_swap(CellId pusher_at, CellId puller_at) const {
  const CellId begin = pusher_at;
  while (puller_at != begin) {
    const WaysOn ways = ways_on(puller_at, pusher_at);
    if (ways.count >= 2) return true;
    if (ways.count == 0) return false;
    pusher_at = std::exchange(puller_at, ways.last);
  }
  return false;
}

int NextMoves::swap_partner(int agent, CellId best, const Configuration& from,
                            const Configuration& to) {
  const CellId here = from[at(agent)];
  if (best == here) return -1;
  const int ahead = now(best);
  if (ahead >= 0 && ahead != agent && to[at(ahead)] == kNowhere &&
      must_swap(agent, ahead, here, best) && can_swap(best, here)) {
    return ahead;
  }
  // One who is drawing back for somebody behind it goes on doing so.
  for (const CellId beside : graph_.beside(here)) {
    const int behind = now(beside);
    if (behind < 0 || beside == best) continue;
    if (must_swap(behind, agent, here, best) && can_swap(best, here)) return behind;
  }
  return -1;
}

}  // namespace rubicon::grid
