#include "src/simulation/schedule/resource_states.hpp"

#include <algorithm>
#include <cassert>

namespace rubicon::schedule {

ResourceStates::ResourceStates(const std::vector<int>& sizes)
    : sizes_(sizes), states_(sizes.size()) {
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    states_[i].free.push_back({sizes[i], 0, -1, false});
    states_[i].free_units = sizes[i];
  }
}

bool ResourceStates::are_free(const std::vector<Share>& shares) const {
  return std::all_of(shares.begin(), shares.end(), [&](const Share& share) {
    const ResourceState& state = of(share.resource);
    return state.free_units >= share.units && (state.reserved < 0 || state.reserved == share.group);
  });
}

ResourceStates::Last ResourceStates::last_free(const std::vector<Share>& shares) const {
  Last last;
  for (const Share& share : shares) {
    const ResourceState& state = of(share.resource);
    int units = 0;
    for (const ResourceState::Free& free : state.free) {
      units += free.units;
      if (units < share.units) continue;
      const bool kept = state.kept_until > free.since;
      const Ticks since = kept ? state.kept_until : free.since;
      // Of a crew some may be kept whom nobody had.
      const int before = kept && free.task_before < 0 ? state.last : free.task_before;
      if (before >= 0 && (last.resource < 0 || since > last.since)) {
        last = {share.resource, before, since, free.midway, kept};
      }
      break;
    }
  }
  return last;
}

void ResourceStates::take(const Share& share, int task) {
  ResourceState& state = states_[at(share.resource)];
  assert(state.free_units >= share.units);
  int left = share.units;
  auto free = state.free.begin();
  while (left > 0 && free != state.free.end() && free->units <= left) left -= (free++)->units;
  if (left > 0) free->units -= left;
  state.free.erase(state.free.begin(), free);
  state.free_units -= share.units;
  state.held.push_back({task, share.units});
  state.last = task;
}

void ResourceStates::release(int resource, int task, Ticks since, bool midway, Ticks held_for) {
  ResourceState& state = states_[at(resource)];
  const auto held =
      std::find_if(state.held.begin(), state.held.end(),
                   [&](const ResourceState::Held& each) { return each.task == task; });
  assert(held != state.held.end());
  const ResourceState::Free free{held->units, since, task, midway};
  state.held.erase(held);
  const auto place = std::upper_bound(
      state.free.begin(), state.free.end(), since,
      [](Ticks time, const ResourceState::Free& each) { return time < each.since; });
  state.free.insert(place, free);
  state.free_units += free.units;
  state.given_back += held_for;
}

}  // namespace rubicon::schedule
