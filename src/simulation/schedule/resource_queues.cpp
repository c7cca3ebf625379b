#include "src/simulation/schedule/resource_queues.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace rubicon::schedule {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

ResourceQueues::ResourceQueues(const Network& network, std::vector<std::string>& mistakes)
    : network_(network), resources_(network.resources.size()) {
  std::map<std::vector<int>, int> known;
  queue_of_.reserve(network.tasks.size());
  for (const NetworkTask& task : network.tasks) {
    std::vector<int> resources = task.resources;
    std::sort(resources.begin(), resources.end());
    const auto [place, is_new] = known.emplace(std::move(resources), 0);
    if (is_new) place->second = add_queue(place->first, mistakes);
    queue_of_.push_back(place->second);
  }
}

int ResourceQueues::add_queue(const std::vector<int>& resources,
                              std::vector<std::string>& mistakes) {
  const int index = static_cast<int>(queues_.size());
  queues_.push_back({resources, common_calendar(resources, mistakes), {}, {}, {}});
  for (const int resource : resources) resources_[at(resource)].queues.push_back(index);
  return index;
}

int ResourceQueues::common_calendar(const std::vector<int>& resources,
                                    std::vector<std::string>& mistakes) {
  std::vector<int> set;
  for (const int resource : resources) {
    const int calendar = network_.resources[at(resource)].calendar;
    if (calendar >= 0) set.push_back(calendar);
  }
  std::sort(set.begin(), set.end());
  set.erase(std::unique(set.begin(), set.end()), set.end());
  const auto place = std::lower_bound(
      calendar_sets_.begin(), calendar_sets_.end(), set,
      [](const auto& known, const std::vector<int>& wanted) { return known.first < wanted; });
  if (place != calendar_sets_.end() && place->first == set) return place->second;
  WorkCalendar common;
  for (const int calendar : set) {
    auto both = intersection(common, network_.calendars[at(calendar)]);
    if (const auto* mistake = std::get_if<CalendarMistake>(&both)) {
      mistakes.push_back(mistake->message);
      break;
    }
    common = std::get<WorkCalendar>(std::move(both));
  }
  const int index = static_cast<int>(calendars_.size());
  calendars_.push_back(std::move(common));
  calendar_sets_.insert(place, {std::move(set), index});
  return index;
}

const WorkCalendar& ResourceQueues::calendar(int task) const {
  return calendars_[at(queues_[at(queue_of_[at(task)])].calendar)];
}

void ResourceQueues::add(int task, Ticks start) {
  const int index = queue_of_[at(task)];
  queues_[at(index)].later.push({start, -network_.tasks[at(task)].priority, task});
  refresh(index);
}

std::optional<ResourceQueues::Next> ResourceQueues::take() {
  if (order_.empty()) return std::nullopt;
  const auto [place, index] = *order_.begin();
  Queue& queue = queues_[at(index)];
  Next next;
  next.start = std::get<Ticks>(place);
  next.task = std::get<int>(place);
  next.resource = last_free(queue);
  if (next.resource >= 0) {
    next.free = resources_[at(next.resource)].free;
    next.task_before = resources_[at(next.resource)].last;
  }
  (queue.waiting.empty() ? queue.later : queue.waiting).pop();
  for (const int resource : queue.resources) {
    resources_[at(resource)].held = true;
    resources_[at(resource)].last = next.task;
  }
  refresh(index);  // one without resources is in none of their lists
  refresh_all(next.task);
  return next;
}

void ResourceQueues::release(int task, Ticks finish) {
  for (const int resource : queues_[at(queue_of_[at(task)])].resources) {
    resources_[at(resource)].held = false;
    resources_[at(resource)].free = finish;
  }
  refresh_all(task);
}

std::vector<std::tuple<int, int, int>> ResourceQueues::stuck() const {
  std::vector<std::tuple<int, int, int>> result;
  for (const Queue& queue : queues_) {
    const Heap& heap = queue.waiting.empty() ? queue.later : queue.waiting;
    if (heap.empty()) continue;
    for (const int resource : queue.resources) {
      if (!resources_[at(resource)].held) continue;
      result.emplace_back(std::get<int>(heap.top()), resource, resources_[at(resource)].last);
      break;
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

void ResourceQueues::refresh(int index) {
  Queue& queue = queues_[at(index)];
  if (queue.first) order_.erase({*queue.first, index});
  queue.first.reset();
  for (const int resource : queue.resources) {
    if (resources_[at(resource)].held) return;
  }
  const int last = last_free(queue);
  Ticks free = -kEndOfTime;
  if (last >= 0) free = calendars_[at(queue.calendar)].next_working(resources_[at(last)].free);
  while (!queue.later.empty() && std::get<Ticks>(queue.later.top()) <= free) {
    Place place = queue.later.top();
    queue.later.pop();
    std::get<Ticks>(place) = 0;
    queue.waiting.push(place);
  }
  if (!queue.waiting.empty()) {
    queue.first = queue.waiting.top();
    std::get<Ticks>(*queue.first) = free;
  } else if (!queue.later.empty()) {
    queue.first = queue.later.top();
  }
  if (queue.first) order_.emplace(*queue.first, index);
}

void ResourceQueues::refresh_all(int task) {
  for (const int resource : queues_[at(queue_of_[at(task)])].resources) {
    for (const int queue : resources_[at(resource)].queues) refresh(queue);
  }
}

int ResourceQueues::last_free(const Queue& queue) const {
  int last = -1;
  for (const int resource : queue.resources) {
    const Resource& each = resources_[at(resource)];
    if (each.last < 0) continue;
    if (last < 0 || each.free > resources_[at(last)].free) last = resource;
  }
  return last;
}

}  // namespace rubicon::schedule
