#include "src/simulation/taskplan/resource_allocator.hpp"

#include <algorithm>

namespace rubicon::taskplan {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void sort_unique(std::vector<int>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

ResourceAllocator::ResourceAllocator(std::vector<std::string> names, std::vector<int> calendar_of,
                                     std::vector<schedule::WorkCalendar> calendars)
    : names_(std::move(names)),
      calendar_of_(std::move(calendar_of)),
      calendars_(std::move(calendars)),
      states_(names_.size()) {
  for (int i = 0; i < static_cast<int>(calendars_.size()); ++i) common_[{i}] = i;
  common_[{}] = static_cast<int>(calendars_.size());
  calendars_.emplace_back();
}

std::variant<int, std::string> ResourceAllocator::common_calendar(
    const std::vector<int>& hours_of) {
  std::vector<int> set;
  for (const int resource : hours_of) {
    if (calendar_of_[at(resource)] >= 0) set.push_back(calendar_of_[at(resource)]);
  }
  sort_unique(set);
  const auto found = common_.find(set);
  if (found != common_.end()) return found->second;
  schedule::WorkCalendar common = calendars_[at(set.front())];
  for (std::size_t i = 1; i < set.size(); ++i) {
    auto both = schedule::intersection(common, calendars_[at(set[i])]);
    if (auto* mistake = std::get_if<schedule::CalendarMistake>(&both)) return mistake->message;
    common = std::get<schedule::WorkCalendar>(std::move(both));
  }
  calendars_.push_back(std::move(common));
  const int index = static_cast<int>(calendars_.size()) - 1;
  common_.emplace(std::move(set), index);
  return index;
}

std::variant<int, std::string> ResourceAllocator::queue_for(std::vector<int> resources,
                                                            std::vector<int> hours_of) {
  sort_unique(resources);
  sort_unique(hours_of);
  const auto key = std::make_pair(resources, hours_of);
  const auto found = queue_of_.find(key);
  if (found != queue_of_.end()) return found->second;
  const auto calendar = common_calendar(hours_of);
  if (const auto* message = std::get_if<std::string>(&calendar)) return *message;
  Queue queue;
  queue.resources = std::move(resources);
  queue.calendar = std::get<int>(calendar);
  queues_.push_back(std::move(queue));
  const int index = static_cast<int>(queues_.size()) - 1;
  queue_of_.emplace(key, index);
  return index;
}

const schedule::WorkCalendar& ResourceAllocator::calendar(int queue) const {
  return calendars_[at(queues_[at(queue)].calendar)];
}

const schedule::WorkCalendar& ResourceAllocator::hours(int resource) const {
  const int calendar = calendar_of_[at(resource)];
  return calendars_[at(calendar >= 0 ? calendar : common_.at({}))];
}

void ResourceAllocator::ask(int queue, int task, double priority, Ticks from) {
  const auto place = std::make_tuple(from, -priority, task);
  queues_[at(queue)].later.insert(place);
  journal_.on_undo([this, queue, place] { queues_[at(queue)].later.erase(place); });
}

bool ResourceAllocator::all_free(const Queue& queue) const {
  return std::all_of(queue.resources.begin(), queue.resources.end(),
                     [&](int resource) { return states_[at(resource)].holder < 0; });
}

/// Those who asked for a later moment that has come.
void ResourceAllocator::move_up(int index, Ticks now) {
  Queue& queue = queues_[at(index)];
  while (!queue.later.empty() && std::get<Ticks>(*queue.later.begin()) <= now) {
    const auto place = *queue.later.begin();
    const Place waits{std::get<double>(place), std::get<int>(place)};
    queue.later.erase(queue.later.begin());
    queue.waiting.insert(waits);
    journal_.on_undo([this, index, place, waits] {
      queues_[at(index)].waiting.erase(waits);
      queues_[at(index)].later.insert(place);
    });
  }
}

void ResourceAllocator::drop_excluded(Queue& queue) {
  if (excluded_.empty()) return;
  while (!queue.waiting.empty() && excluded_.contains(queue.waiting.begin()->second)) {
    queue.waiting.erase(queue.waiting.begin());
  }
  while (!queue.later.empty() && excluded_.contains(std::get<int>(*queue.later.begin()))) {
    queue.later.erase(queue.later.begin());
  }
}

std::optional<ResourceAllocator::Grant> ResourceAllocator::take(Ticks now) {
  int best = -1;
  for (int i = 0; i < static_cast<int>(queues_.size()); ++i) {
    Queue& queue = queues_[at(i)];
    if (!all_free(queue)) continue;
    move_up(i, now);
    drop_excluded(queue);
    if (queue.waiting.empty() || !calendars_[at(queue.calendar)].works_at(now)) continue;
    if (best < 0 || *queue.waiting.begin() < *queues_[at(best)].waiting.begin()) best = i;
  }
  if (best < 0) return std::nullopt;
  Queue& queue = queues_[at(best)];
  const Place place = *queue.waiting.begin();
  queue.waiting.erase(queue.waiting.begin());
  journal_.on_undo([this, best, place] { queues_[at(best)].waiting.insert(place); });
  Grant grant;
  grant.task = place.second;
  grant.queue = best;
  grant.before = states_;
  for (const int resource : queue.resources) {
    ResourceState& state = states_[at(resource)];
    if (state.last >= 0 && (grant.resource < 0 || state.free_since > grant.free)) {
      grant.resource = resource;
      grant.free = state.free_since;
      grant.task_before = state.last;
      grant.midway = state.midway;
    }
    take_directly(resource, grant.task);
  }
  return grant;
}

void ResourceAllocator::take_directly(int resource, int task) {
  states_[at(resource)].holder = task;
  states_[at(resource)].last = task;
}

void ResourceAllocator::release(int resource, Ticks now, bool midway) {
  states_[at(resource)].holder = -1;
  states_[at(resource)].free_since = now;
  states_[at(resource)].midway = midway;
}

Ticks ResourceAllocator::next_chance(Ticks now) {
  Ticks next = schedule::kEndOfTime;
  for (Queue& queue : queues_) {
    drop_excluded(queue);
    if ((queue.later.empty() && queue.waiting.empty()) || !all_free(queue)) continue;
    const Ticks from = queue.waiting.empty() ? std::get<Ticks>(*queue.later.begin()) : now;
    const Ticks chance = calendars_[at(queue.calendar)].next_working(std::max(from, now));
    if (chance > now) next = std::min(next, chance);
  }
  return next;
}

}  // namespace rubicon::taskplan
