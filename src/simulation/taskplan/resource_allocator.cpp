#include "src/simulation/taskplan/resource_allocator.hpp"

#include <algorithm>

#include "src/motion/math/index.hpp"

namespace rubicon::taskplan {

namespace {

using math::at;

}  // namespace

ResourceAllocator::ResourceAllocator(std::vector<std::string> names, const std::vector<int>& sizes,
                                     std::vector<int> calendar_of,
                                     std::vector<schedule::WorkCalendar> calendars)
    : names_(std::move(names)),
      sets_(std::move(calendar_of), std::move(calendars)),
      states_(sizes) {}

std::variant<int, std::string> ResourceAllocator::queue_for(std::vector<Share> shares,
                                                            std::vector<int> hours_of) {
  auto set = sets_.set_of(std::move(shares), std::move(hours_of));
  queues_.resize(static_cast<std::size_t>(sets_.size()));
  return set;
}

void ResourceAllocator::ask(int queue, int task, double priority, Ticks from) {
  const auto place = std::make_tuple(from, -priority, task);
  if (!queues_[at(queue)].later.insert(place).second) return;
  journal_.on_undo([this, queue, place] { queues_[at(queue)].later.erase(place); });
}

/// Those who asked for a later moment that has come.
void ResourceAllocator::move_up(int index, Ticks now) {
  Queue& queue = queues_[at(index)];
  while (!queue.later.empty() && std::get<Ticks>(*queue.later.begin()) <= now) {
    const auto place = *queue.later.begin();
    const Place waits{std::get<double>(place), std::get<int>(place)};
    queue.later.erase(queue.later.begin());
    // A task that asks again may have waited here all the time.
    const bool is_new = queue.waiting.insert(waits).second;
    journal_.on_undo([this, index, place, waits, is_new] {
      if (is_new) queues_[at(index)].waiting.erase(waits);
      queues_[at(index)].later.insert(place);
    });
  }
}

void ResourceAllocator::drop_those_who_ask_no_more(int index) {
  Queue& queue = queues_[at(index)];
  while (!queue.waiting.empty() && asks_no_more(queue.waiting.begin()->second, index)) {
    const Place place = *queue.waiting.begin();
    queue.waiting.erase(queue.waiting.begin());
    journal_.on_undo([this, index, place] { queues_[at(index)].waiting.insert(place); });
  }
  while (!queue.later.empty() && asks_no_more(std::get<int>(*queue.later.begin()), index)) {
    const auto place = *queue.later.begin();
    queue.later.erase(queue.later.begin());
    journal_.on_undo([this, index, place] { queues_[at(index)].later.insert(place); });
  }
}

std::optional<ResourceAllocator::Grant> ResourceAllocator::take(Ticks now) {
  std::vector<int> bests;  // more than one: of the same task
  for (int i = 0; i < sets_.size(); ++i) {
    const Queue& queue = queues_[at(i)];
    if (queue.is_empty() || !all_free(i) || out_until(i) > now) continue;
    move_up(i, now);
    drop_those_who_ask_no_more(i);
    if (queue.waiting.empty() || !calendar(i).works_at(now)) continue;
    const Place& first = *queue.waiting.begin();
    if (!bests.empty() && first < *queues_[at(bests.front())].waiting.begin()) bests.clear();
    if (bests.empty() || first == *queues_[at(bests.front())].waiting.begin()) bests.push_back(i);
  }
  if (bests.empty()) return std::nullopt;
  int best = bests.front();
  if (bests.size() > 1) {
    best = choices_.in_one_of(queues_[at(best)].waiting.begin()->second, bests);
  }
  Queue& queue = queues_[at(best)];
  const Place place = *queue.waiting.begin();
  queue.waiting.erase(queue.waiting.begin());
  journal_.on_undo([this, best, place] { queues_[at(best)].waiting.insert(place); });
  Grant grant;
  grant.task = place.second;
  grant.queue = best;
  grant.last = states_.last_free(sets_.shares(best));
  grant.before = mark();
  for (const Share& share : sets_.shares(best)) take_directly(share, grant.task);
  return grant;
}

void ResourceAllocator::keep_state(int resource) {
  journal_.on_undo([this, resource, state = states_.of(resource)]() mutable {
    states_.set(resource, std::move(state));
  });
}

void ResourceAllocator::take_directly(const Share& share, int task) {
  keep_state(share.resource);
  states_.take(share, task);
}

void ResourceAllocator::release(int resource, int task, Ticks now, bool midway, Ticks held) {
  keep_state(resource);
  states_.release(resource, task, now, midway, held);
}

void ResourceAllocator::set_out(int resource, Ticks until) {
  out_.resize(names_.size());
  journal_.on_undo([this, resource, before = out_[at(resource)]] { out_[at(resource)] = before; });
  out_[at(resource)] = until;
}

Ticks ResourceAllocator::out_until(int queue) const {
  Ticks until = 0;
  if (out_.empty()) return until;
  for (const int resource : sets_.resources(queue)) until = std::max(until, out_[at(resource)]);
  return until;
}

void ResourceAllocator::reserve(int resource, int group) {
  keep_state(resource);
  states_.reserve(resource, group);
}

void ResourceAllocator::keep_no_more(int resource, Ticks now) {
  keep_state(resource);
  states_.keep_no_more(resource, now);
}

Ticks ResourceAllocator::next_chance(Ticks now) {
  Ticks next = schedule::kEndOfTime;
  for (int i = 0; i < sets_.size(); ++i) {
    const Queue& queue = queues_[at(i)];
    if (queue.is_empty() || !all_free(i)) continue;
    drop_those_who_ask_no_more(i);
    if (queue.is_empty()) continue;
    const Ticks from = queue.waiting.empty() ? std::get<Ticks>(*queue.later.begin()) : now;
    const Ticks chance = calendar(i).next_working(std::max({from, now, out_until(i)}));
    if (chance > now) next = std::min(next, chance);
  }
  return next;
}

}  // namespace rubicon::taskplan
